#version 450
#extension GL_ARB_sparse_texture2 : enable
in vec3 v;
out vec4 o;
float min3(float a, float b, float c) { return min(a, min(b, c)); }
void main() {
    float float16_t = min3(v.x, v.y, v.z);
    o = vec4(exp(sin(float16_t * v)), 1.0);
}
