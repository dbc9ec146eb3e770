#version 430 core
in vec3 v_p;
in vec3 v_n;
layout(std430, binding = 3) readonly restrict buffer Palette { vec4 tint[]; };
layout(rgba32f, binding = 0) restrict readonly uniform image2D u_map;
uniform readonly coherent layout(rgba32f, binding = 1) image2D u_other;
out vec4 o;

vec3 costly(const in vec3 p) {
    vec3 s = sin(p * 5.0);
    for (int i = 0; i < 3; i++) {
        s = exp(sin(s.yzx * 2.0 + p));
    }
    return s * 0.3;
}


void main() {
    vec4 shade = tint[1] + imageLoad(u_map, ivec2(0)) + imageLoad(u_other, ivec2(1));
    o = vec4(costly(v_p) * max(v_n.z, 0.2), 1.0) * shade;
}
