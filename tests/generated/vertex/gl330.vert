#version 330
in vec3 a_position;
in vec3 a_normal;
in vec2 a_uv;
uniform mat4 u_mvp;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;
void main() {
    v_position = a_position;
    v_normal = a_normal;
    v_uv = a_uv;
    gl_Position = u_mvp * vec4(a_position, 1.0);
}
