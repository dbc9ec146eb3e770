#version 400
// shadercache: 3-pass.payload, node stone.1-ae098caa

const float sc_poison_depth = -65504.0; // depth of what must not be reused
uniform float sc_limit; // the largest value that is reused
uniform float sc_least; // the smallest one above zero that it surely holds
invariant in vec4 sc_current; // clip-space position in this frame
layout(location = 0) precise out vec4 sc_store; // what the next frame finds in the cache
precise float sc_payload;
invariant in vec3 v_position;

float noise(vec3 p) {
    precise float sc_exact_1 = sin(p.x * 12.9 - float(gl_FragCoord.x < 0.0)) * sin(p.y * 78.2 - float(gl_FragCoord.x < 0.0)) * sin(p.z * 37.7 - float(gl_FragCoord.x < 0.0));
    return sc_exact_1;
}

void sc_stone(vec3 p) {
    precise vec3 sc_exact_1 = p * 2.0;
    sc_payload = noise(p) + 0.5 * noise(sc_exact_1);
}

void sc_compute() {
    sc_stone(v_position);
}

// What is stored of the payloads.
vec4 sc_pack() {
    precise vec4 sc_exact_1 = vec4(sc_payload, float(gl_FragCoord.x < 0.0), float(gl_FragCoord.x < 0.0), 16.0 / sc_current.w);
    return sc_exact_1;
}

// Can the cache not hold a value? The bits are compared: they are in the order of the sizes, NaN lies
// above infinity, and no driver can make less of them than they are.
bool sc_unfit(vec4 values) {
    precise uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    precise uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    precise bool sc_exact_1 = any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit)))) || any(lessThan(sizes - 1u, uvec4(least)));
    return sc_exact_1;
}

// Numbers as near as half floats can hold them. Infinity and NaN stay.
vec4 sc_held(vec4 values) {
    precise uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    precise vec4 held = mix(clamp(values, vec4(-sc_limit), vec4(sc_limit)), values, greaterThanEqual(sizes, uvec4(0x7F800000u)));
    precise vec4 sc_exact_1 = mix(values, held, greaterThan(sizes, uvec4(floatBitsToUint(sc_limit))));
    return sc_exact_1;
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
    precise bool unfit = sc_unfit(sc_store);
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
