#version 440 core
// A block here, variables there. (Mesa does not link them.)
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
layout(location = 0) out Out { vec3 at; vec3 facing; };
void main() { at = a_position; facing = a_normal; gl_Position = u_mvp * vec4(a_position, 1.0); }
