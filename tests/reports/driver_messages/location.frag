#version 430 core
uniform vec2 u_resolution; layout(location = 99999999) uniform float u_far;
out vec4 o;
void main() { o = vec4(u_far * exp(sin(gl_FragCoord.x / u_resolution.x * 9.0))); }
