#version 440 core
// Members of blocks with places; the block's name is the same.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
out Surface { layout(location = 1) vec3 at; layout(location = 0) vec3 facing; } o_s;
void main() { o_s.at = a_position; o_s.facing = a_normal; gl_Position = u_mvp * vec4(a_position, 1.0); }
