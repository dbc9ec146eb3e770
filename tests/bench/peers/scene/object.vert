#version 330
in vec3 a_position;
in vec3 a_normal;
uniform mat4 u_modelViewProjection;
out vec3 v_position;
out vec3 v_normal;

void main() {
    v_position = a_position;
    v_normal = a_normal;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}
