#version 410 core
// Written as a member of the block's instance; no driver takes the name, the variants do without.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n;
uniform mat4 u_mvp;
out gl_PerVertex { vec4 gl_Position; } self;
void main() { v_p = a_position; v_n = a_normal; self.gl_Position = u_mvp * vec4(a_position, 1.0); }
