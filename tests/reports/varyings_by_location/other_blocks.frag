#version 440 core
// Blocks of other names and members. (Mesa does not link them.)
in In { layout(location = 1) vec3 n; layout(location = 0) vec3 p; } i_s;
vec3 costly(vec3 p) { vec3 s = sin(p * 5.0); for (int i = 0; i < 3; i++) s = exp(sin(s.yzx * 2.0 + p)); return s * 0.3; }
out vec4 o;
void main() { o = vec4(costly(i_s.p) * max(i_s.n.z, 0.2), 1.0); }
