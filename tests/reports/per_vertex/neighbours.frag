#version 450 core
#extension GL_EXT_fragment_shader_barycentric : require
layout(location = 0) pervertexEXT in vec3 v_p[]; layout(location = 1) pervertexEXT in vec3 v_n[];
vec3 costly(vec3 p) { vec3 s = sin(p * 5.0); for (int i = 0; i < 3; i++) s = exp(sin(s.yzx * 2.0 + p)); return s * 0.3; }
out vec4 o;
void main() { o = vec4(costly(v_p[0]) * max(v_n[1].z, 0.2), 1.0); }
