#version 450
#extension GL_ARB_sparse_texture2 : enable
in vec3 v;
uniform sampler2D s;
out vec4 o;
void main() { vec4 t; int c = sparseTextureARB(s, v.xy, t); o = t; }
