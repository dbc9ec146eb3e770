#version 320 es
// The block of GLSL ES 3.20.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n;
uniform mat4 u_mvp;
out gl_PerVertex { highp vec4 gl_Position; };
void main() { v_p = a_position; v_n = a_normal; gl_Position = u_mvp * vec4(a_position, 1.0); }
