#version 440 core
// Components of one location.
layout(location = 0, component = 2) in float third; layout(location = 1) in vec3 n; layout(location = 0, component = 0) in vec2 two;
vec3 costly(vec3 p) { vec3 s = sin(p * 5.0); for (int i = 0; i < 3; i++) s = exp(sin(s.yzx * 2.0 + p)); return s * 0.3; }
out vec4 o;
void main() { o = vec4(costly(vec3(two, third)) * max(n.z, 0.2), 1.0); }
