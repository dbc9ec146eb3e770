#version 330
// The matrices lie in a block.
in vec3 a_position;
layout(std140) uniform Camera {
    mat4 u_view;
    mat4 u_projection;
} camera;
uniform mat4 u_model;
out vec3 v_position;
void main() {
    v_position = a_position;
    gl_Position = camera.u_projection * camera.u_view * u_model * vec4(a_position, 1.0);
}
