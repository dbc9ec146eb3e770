#version 330
// shadercache: 3-pass.payload, node main.11-a0ace7bc

in vec4 sc_current;
layout(location = 0) out uvec4 sc_store;
layout(location = 1) out uvec4 sc_store_2;
uniform float sc_limit;
uniform float sc_least;
in vec3 v_position;

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

void sc_compute() {
    vec4 wave = sin(9.0 * v_position.xyzx) * cos(5.0 * v_position.yzxy);
    sc_payload = Mixed(Pair(wave.xy, wave.z), wave.x > 0.3, ivec2(2.0 * wave.yz), uint(3.0 + wave.x));
}

uvec4 sc_texel() {
    return uvec4(floatBitsToUint(sc_payload.pair.a), floatBitsToUint(sc_payload.pair.b), floatBitsToUint(16.0 / sc_current.w));
}

uvec4 sc_texel_2() {
    return uvec4(uint(sc_payload.sign), uvec2(sc_payload.cell), sc_payload.number);
}

bool sc_unfit(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    return any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit)))) || any(lessThan(sizes - 1u, uvec4(least)));
}

void sc_guard() {
    bool unfit = sc_unfit(uintBitsToFloat(sc_store & ~uvec4(0u, 0u, 0u, 0u)));
    unfit = unfit || sc_unfit(uintBitsToFloat(sc_store_2 & ~uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu)));
    if (unfit) {
        sc_store.w = 0xFF000000u;
    }
}

void main() {
    sc_compute();
    sc_store = sc_texel();
    sc_store_2 = sc_texel_2();
    sc_guard();
}
