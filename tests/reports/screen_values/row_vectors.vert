#version 440 core
// Vectors stand on the left, and varyings match by their places.
in vec3 a_position;
layout(std140) uniform Camera { mat4 view; mat4 projection; } camera;
uniform mat4 u_model;
layout(location = 0) out vec4 clip; layout(location = 1) out vec3 eye; layout(location = 2) out vec3 world;
void main() {
    vec4 at = vec4(a_position, 1.0) * u_model;
    world = at.xyz;
    eye = (at * camera.view).xyz;
    gl_Position = at * camera.view * camera.projection;
    clip = vec4(eye, 1.0) * camera.projection;
}
