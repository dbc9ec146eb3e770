#version 310 es
precision highp float;
highp in vec3 v_p;
layout(rgba8, binding = 0) highp readonly uniform image2D u_map;
restrict writeonly layout(rgba8, binding = 1) uniform mediump image2D u_out;
coherent layout(std430, binding = 2) readonly buffer Palette { vec4 tint[]; } palette;
out mediump vec4 o;

void main() {
    imageStore(u_out, ivec2(0), vec4(1.0));
    o = vec4(v_p, 1.0) * imageLoad(u_map, ivec2(0)) * palette.tint[1];
}
