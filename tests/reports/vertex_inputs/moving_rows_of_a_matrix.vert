// TWINNED: i_rows
// NAMED: a_position
#version 330 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
in mat4x3 i_rows;
void main() {
    v_p = a_position; v_n = a_normal;
    gl_Position = u_vp * vec4(i_rows * vec4(a_position, 1.0), 1.0);
}
