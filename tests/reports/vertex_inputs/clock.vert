// REFUSED: SC463 clock2x32ARB
#version 450 core
#extension GL_ARB_shader_clock : require
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
float now() { return float(clock2x32ARB().x); }
void main() { v_p = a_position; v_n = a_normal; gl_Position = u_vp * vec4(a_position * now(), 1.0); }
