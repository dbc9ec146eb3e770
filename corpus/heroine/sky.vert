#version 330
// A wall of haze around the court: it is far away and does not move with the camera.

in vec3 a_position;

uniform mat4 u_model;
uniform mat4 u_viewProjection;

out vec3 v_world;  // world space

void main() {
    vec4 world = u_model * vec4(a_position, 1.0);
    v_world = world.xyz;
    gl_Position = u_viewProjection * world;
}
