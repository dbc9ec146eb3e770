#version 330
// shadercache: 3-pass.payload, node main.11-a0ace7bc

in vec4 sc_current;
layout(location = 1) out uvec4 sc_store;
layout(location = 2) out uvec4 sc_store_2;
uniform float sc_limit;
uniform float sc_least;
in vec3 v_position;
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
    vec4 wave = sin(9.0 * v_position.xyzx) * cos(5.0 * v_position.yzxy);
    sc_payload = Mixed(Pair(wave.xy, wave.z), wave.x > 0.3, ivec2(2.0 * wave.yz), uint(3.0 + wave.x));
    Mixed it = sc_payload;
    o_color = vec4(0.5 + 0.5 * (vec3(it.pair.a, it.pair.b) * (it.sign ? 1.0 : 0.4) + vec3(it.cell, it.number) / 9.0) * normalize(v_normal).z, 1.0);
}

uvec4 sc_texel() {
    return uvec4(floatBitsToUint(sc_payload.pair.a), floatBitsToUint(sc_payload.pair.b), floatBitsToUint(16.0 / sc_current.w));
}

uvec4 sc_texel_2() {
    return uvec4(uint(sc_payload.sign), uvec2(sc_payload.cell), sc_payload.number);
}

bool sc_unfit(vec4 values) {
    vec4 sizes = abs(values);
    return any(isnan(values)) || any(greaterThan(sizes, vec4(sc_limit))) || any(lessThan(sizes, sc_least * vec4(notEqual(values, vec4(0.0)))));
}

void sc_guard() {
    bool unfit = sc_unfit(uintBitsToFloat(sc_store & ~uvec4(0u, 0u, 0u, 0u)));
    unfit = unfit || sc_unfit(uintBitsToFloat(sc_store_2 & ~uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu)));
    if (unfit && sc_store.w != 0u) {
        sc_store = uvec4(0u, 0u, 0u, 0x80000000u);
        sc_store_2 = uvec4(0);
    }
}

void main() {
    sc_shade();
    sc_store = sc_texel();
    sc_store_2 = sc_texel_2();
    sc_guard();
}
