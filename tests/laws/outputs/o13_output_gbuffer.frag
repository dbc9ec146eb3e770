#version 330 core
in vec3 v_p; in vec3 v_n;
vec3 costly(vec3 p) { vec3 s = sin(p * 5.0); for (int i = 0; i < 3; i++) s = exp(sin(s.yzx * 2.0 + p)); return s * 0.3; }
layout(location = 0) out vec4 g_albedo;
layout(location = 1) out vec4 g_normal;
layout(location = 2) out vec4 g_material;
void main() { vec3 rock = costly(v_p); g_albedo = vec4(rock, 1.0); g_normal = vec4(normalize(v_n), 1.0); g_material = vec4(rock.x, 0.5, 0.0, 1.0); }
