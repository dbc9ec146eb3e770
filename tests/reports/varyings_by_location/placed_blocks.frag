#version 440 core
// A block at a place, whose members follow each other; without instance names.
layout(location = 4) in Surface { mat3 frame; vec3 at; vec3 facing; };
vec3 costly(vec3 p) { vec3 s = sin(p * 5.0); for (int i = 0; i < 3; i++) s = exp(sin(s.yzx * 2.0 + p)); return s * 0.3; }
out vec4 o;
void main() { o = vec4(costly(frame * at) * max(facing.z, 0.2), 1.0); }
