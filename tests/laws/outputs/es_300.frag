#version 300 es
// Two targets of WebGL 2.
precision highp float;
precision highp int;

in vec3 p;
in vec3 n;

layout(location = 0) out mediump vec4 o_color;
layout(location = 1) out uvec4 o_bits;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void main() {
    float grain = noise(p);
    o_color = vec4(vec3(0.5 + 0.5 * grain * n.z), 1.0);
    o_bits = uvec4(floatBitsToUint(grain), 1u, 2u, 3u);
}
