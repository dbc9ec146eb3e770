#version 330
// Three matrices, each of its own.
in vec3 a_position;
in vec3 a_normal;
uniform mat4 u_model;
uniform mat4 u_view;
uniform mat4 u_projection;
out vec3 v_position;
out vec3 v_normal;
void main() {
    v_position = a_position;
    v_normal = mat3(u_model) * a_normal;
    gl_Position = u_projection * (u_view * (u_model * vec4(a_position, 1.0)));
}
