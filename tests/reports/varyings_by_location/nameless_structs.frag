#version 440 core
// Structs without names match by their members, at a place or by the variable's name.
layout(location = 2) in struct { vec3 at; vec3 facing; } s; in struct { float one; } plain;
vec3 costly(vec3 p) { vec3 s = sin(p * 5.0); for (int i = 0; i < 3; i++) s = exp(sin(s.yzx * 2.0 + p)); return s * 0.3; }
out vec4 o;
void main() { o = vec4(costly(s.at * plain.one) * max(s.facing.z, 0.2), 1.0); }
