// TWINNED: instanceOffset, i_inst_turn
// NAMED: a_position
#version 330 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
in vec3 instanceOffset; in vec4 i_inst_turn;
void main() {
    v_p = a_position; v_n = a_normal;
    gl_Position = u_vp * vec4(a_position * i_inst_turn.xyz + instanceOffset, 1.0);
}
