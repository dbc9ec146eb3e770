#version 300 es
// shadercache: 2-pass.miss, node main.20-0b86b19f

precision mediump float;
const highp float sc_poison_depth = -65504.0; // depth of what must not be reused
uniform highp float sc_limit; // the largest value that is reused
uniform highp float sc_least; // the smallest one above zero that it surely holds
layout(location = 1) out highp vec4 sc_store; // what the next frame finds in the cache
highp float sc_payload;

// A flat pattern that scrolls to the left: only where it was is said, not where the pixel is.
uniform highp vec2 u_resolution;
uniform highp float u_time;
layout(location = 0) out vec4 o_color;
const highp float SPEED = 0.7;

highp vec2 place(highp float time) {
    return 2.0 * gl_FragCoord.xy / u_resolution - 1.0 + vec2(SPEED * time, 0.0);
}

highp float pattern(highp vec2 p) {
    return sin(9.0 * p.x + 2.0 * sin(5.0 * p.y)) * cos(7.0 * p.y + sin(3.0 * p.x));
}

void sc_shade() {
    highp float rings = pattern(place(u_time)) + 0.3 * pattern(2.3 * place(u_time).yx);
    sc_payload = rings;
    o_color = vec4(vec3(0.5 + 0.3 * sc_payload), 1.0);
}

// What is stored of the payloads.
highp vec4 sc_pack() {
    return vec4(sc_payload, 0.0, 0.0, 16.0 * gl_FragCoord.w);
}

// Can the cache not hold a value? The bits are compared: they are in the order of the sizes, NaN lies
// above infinity, and no driver can make less of them than they are.
bool sc_unfit(highp vec4 values) {
    highp uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    highp uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    return any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit)))) || any(lessThan(sizes - 1u, uvec4(least)));
}

// Numbers as near as half floats can hold them. Infinity and NaN stay.
highp vec4 sc_held(highp vec4 values) {
    highp uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    highp vec4 held = mix(clamp(values, vec4(-sc_limit), vec4(sc_limit)), values, greaterThanEqual(sizes, uvec4(0x7F800000u)));
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

// Two passes, second: the whole shader, for the pixels that the first pass left open.
void main() {
    sc_shade();
    sc_store = sc_pack();
    sc_guard();
}
