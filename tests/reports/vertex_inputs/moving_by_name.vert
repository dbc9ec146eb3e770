// MOVING: a_position
// MOVING: none
// TWINNED: a_position
// NAMED: u_bones
#version 330 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
uniform sampler2D u_bones;
void main() {
    v_p = a_position; v_n = a_normal;
    gl_Position = u_vp * (vec4(a_position, 1.0) + texture(u_bones, a_position.xy));
}
