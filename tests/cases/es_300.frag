#version 300 es
// GLSL ES 3.00: precisions of every kind, integers, an array constructor, textureGrad.
precision highp float;
precision mediump int;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform sampler2D u_map;
uniform float u_time;
layout(location = 0) out highp vec4 o_color;

mediump float wave(highp vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

void main() {
    int at = int(v_uv.x * 2.999);
    float table[3] = float[](0.25, wave(v_position), 0.75);
    lowp vec3 base = texture(u_map, v_uv).rgb + textureGrad(u_map, v_uv, vec2(0.01), vec2(0.02)).rgb;
    uint bits = uint(v_uv.y * 16.0) ^ 5u;
    mediump float b = wave(v_normal) * table[at] + u_time;
    o_color = vec4(base * b, float(bits) * 0.0625) + texelFetch(u_map, ivec2(at), 0) * wave(v_normal * 2.0);
}
