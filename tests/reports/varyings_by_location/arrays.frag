#version 410 core
// Arrays and matrices take several locations.
layout(location = 5) in vec3 z; layout(location = 2) in mat3 m; layout(location = 0) in vec3 both[2];
vec3 costly(vec3 p) { vec3 s = sin(p * 5.0); for (int i = 0; i < 3; i++) s = exp(sin(s.yzx * 2.0 + p)); return s * 0.3; }
out vec4 o;
void main() { o = vec4(costly(m * both[0]) * max((both[1] + z).z, 0.2), 1.0); }
