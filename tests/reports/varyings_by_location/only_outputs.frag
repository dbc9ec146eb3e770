#version 410 core
// One stage alone has places: names match, whatever the driver makes of it.
in vec3 v_n; in vec3 v_p;
vec3 costly(vec3 p) { vec3 s = sin(p * 5.0); for (int i = 0; i < 3; i++) s = exp(sin(s.yzx * 2.0 + p)); return s * 0.3; }
out vec4 o;
void main() { o = vec4(costly(v_p) * max(v_n.z, 0.2), 1.0); }
