#version 450
#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require
in vec3 v;
out vec4 o;
void main() { float16_t x = float16_t(v.x); o = vec4(float(x)); }
