
#version 460 core
uniform vec2 u_resolution;
out vec4 o;
void main() { o = vec4(exp(sin(gl_FragCoord.x / u_resolution.x * 9.0))); }
