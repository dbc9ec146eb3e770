#version 330
// shadercache: 3-pass.payload, node stone.27-f6bd6cd8

const float sc_poison_depth = -65504.0; // depth of what must not be reused
uniform float sc_limit; // the largest value that is reused
uniform float sc_least; // the smallest one above zero that it surely holds
in vec4 sc_current; // clip-space position in this frame
layout(location = 0) out vec4 sc_store; // what the next frame finds in the cache
vec3 sc_payload;
uniform sampler2D u_map;
in vec3 v_position;

void sc_stone(vec3 p) {
    vec4 grain = texture(u_map, p.xy);
    sc_payload = grain.rgb;
}

void sc_compute() {
    sc_stone(v_position);
}

// What is stored of the payloads.
vec4 sc_pack() {
    return vec4(sc_payload, 16.0 / sc_current.w);
}

// Can the cache not hold a value? The bits are compared: they are in the order of the sizes, NaN lies
// above infinity, and no driver can make less of them than they are.
bool sc_unfit(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    return any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit)))) || any(lessThan(sizes - 1u, uvec4(least)));
}

// Numbers as near as half floats can hold them. Infinity and NaN stay.
vec4 sc_held(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    vec4 held = mix(clamp(values, vec4(-sc_limit), vec4(sc_limit)), values, greaterThanEqual(sizes, uvec4(0x7F800000u)));
    return mix(values, held, greaterThan(sizes, uvec4(floatBitsToUint(sc_limit))));
}

// A cache of half floats is written what it can hold.
void sc_hold() {
    if (sc_limit <= 65504.0) {
        sc_store = sc_held(sc_store);
    }
}

// Marks a texel that must not be reused. The third of three passes reads it in this frame, so it
// holds what was computed, or what comes nearest of larger numbers.
void sc_guard() {
    bool unfit = sc_unfit(sc_store);
    if (unfit) {
        sc_hold();
        sc_store.w = sc_poison_depth;
    }
}

// Three passes, second: the payload alone, for the pixels that the first pass left open.
void main() {
    sc_compute();
    sc_store = sc_pack();
    sc_guard();
}
