#version 330 core
// There is no line that is wrong.
uniform vec2 u_resolution;
uniform vec4 u_many[200000];
out vec4 o;
void main() { o = u_many[int(u_resolution.x)] * exp(sin(u_resolution.y * 9.0)); }
