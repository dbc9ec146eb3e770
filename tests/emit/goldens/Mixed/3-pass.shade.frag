#version 330
// shadercache: 3-pass.shade, node main.11-a0ace7bc

uniform usampler2D sc_payloads; // what this frame has stored so far
uniform usampler2D sc_payloads_2;
in vec3 v_normal;
layout(location = 0) out vec4 o_color;

struct Pair {
    vec2 a;
    float b;
};

struct Mixed {
    Pair pair;
    bool sign;
    ivec2 cell;
    uint number;
};

Mixed sc_payload;

void sc_shade() {
    Mixed it = sc_payload;
    o_color = vec4(0.5 + 0.5 * (vec3(it.pair.a, it.pair.b) * (it.sign ? 1.0 : 0.4) + vec3(it.cell, it.number) / 9.0) * normalize(v_normal).z, 1.0);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    uvec4 sc_texel = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0);
    uvec4 sc_texel_2 = texelFetch(sc_payloads_2, ivec2(gl_FragCoord.xy), 0);
    sc_payload = Mixed(Pair(uintBitsToFloat(sc_texel.xy), uintBitsToFloat(sc_texel.z)), bool(sc_texel_2.x), ivec2(sc_texel_2.yz), sc_texel_2.w);
    sc_shade();
}
