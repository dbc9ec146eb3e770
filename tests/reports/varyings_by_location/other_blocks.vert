#version 440 core
// Blocks of other names and members. (Mesa does not link them.)
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
layout(location = 0) out Out { vec3 at; vec3 facing; } o_s;
void main() { o_s.at = a_position; o_s.facing = a_normal; gl_Position = u_mvp * vec4(a_position, 1.0); }
