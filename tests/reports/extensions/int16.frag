#version 450
#extension GL_EXT_shader_explicit_arithmetic_types_int16 : enable
in vec3 v;
out vec4 o;
int16_t f(i16vec2 q) { return q.x; }
void main() { o = vec4(0); }
