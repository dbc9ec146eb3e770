#version 330 core

in vec3 a_position;
uniform mat4 u_viewProjection;
out vec3 v_position;

void main() {
    v_position = a_position;
    gl_Position = u_viewProjection * vec4(a_position, 1.0);
}
