#version 330 core
in vec3 v_p;
vec3 costly(vec3 p) { vec3 s = sin(p * 5.0); for (int i = 0; i < 3; i++) s = exp(sin(s.yzx * 2.0 + p)); return s * 0.3; }
out vec3 o;
void main() { o = costly(v_p); }
