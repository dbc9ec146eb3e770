#version 440 core
// Structs of other names.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
struct Out { vec3 at; vec3 facing; }; layout(location = 0) out Out surface;
void main() { surface = Out(a_position, a_normal); gl_Position = u_mvp * vec4(a_position, 1.0); }
