#version 440 core
// Members of blocks with places; the block's name is the same.
in Surface { layout(location = 1) vec3 at; layout(location = 0) vec3 facing; } i_s;
vec3 costly(vec3 p) { vec3 s = sin(p * 5.0); for (int i = 0; i < 3; i++) s = exp(sin(s.yzx * 2.0 + p)); return s * 0.3; }
out vec4 o;
void main() { o = vec4(costly(i_s.at) * max(i_s.facing.z, 0.2), 1.0); }
