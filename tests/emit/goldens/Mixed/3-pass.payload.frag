#version 330
// shadercache: 3-pass.payload, node main.11-a0ace7bc

const uint sc_poison_depth = 0xFF000000u; // depth of what must not be reused
uniform float sc_limit; // the largest value that is reused
uniform float sc_least; // the smallest one above zero that it surely holds
in vec4 sc_current; // clip-space position in this frame
layout(location = 0) out uvec4 sc_store; // what the next frame finds in the cache
layout(location = 1) out uvec4 sc_store_2;
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

// What is stored of the payloads.
uvec4 sc_pack() {
    return uvec4(floatBitsToUint(sc_payload.pair.a), floatBitsToUint(sc_payload.pair.b), floatBitsToUint(16.0 / sc_current.w));
}

uvec4 sc_pack_2() {
    return uvec4(uint(sc_payload.sign), uvec2(sc_payload.cell), sc_payload.number);
}

// Can the cache not hold a value? The bits are compared: they are in the order of the sizes, NaN lies
// above infinity, and no driver can make less of them than they are.
bool sc_unfit(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    return any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit)))) || any(lessThan(sizes - 1u, uvec4(least)));
}

// Marks a texel that must not be reused. The third of three passes reads it in this frame, so it
// holds what was computed, or what comes nearest of larger numbers.
void sc_guard() {
    bool unfit = sc_unfit(uintBitsToFloat(sc_store));
    if (unfit) {
        sc_store.w = sc_poison_depth;
    }
}

// Three passes, second: the payload alone, for the pixels that the first pass left open.
void main() {
    sc_compute();
    sc_store = sc_pack();
    sc_store_2 = sc_pack_2();
    sc_guard();
}
