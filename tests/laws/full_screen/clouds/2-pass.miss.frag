#version 330
// shadercache: 2-pass.miss, node mainImage.23-b73a27b8

// A Shadertoy of our own: clouds that stand still above a sea that moves. Of the clouds nothing
// depends on iTime, so the value of the same pixel stays right for ever.

const float sc_poison_depth = -65504.0; // depth of what must not be reused
uniform float sc_limit; // the largest value that is reused
uniform float sc_least; // the smallest one above zero that it surely holds
layout(location = 1) out vec4 sc_store; // what the next frame finds in the cache
float sc_payload;
uniform vec3 iResolution;
uniform float iTime;
uniform sampler2D iChannel0;
layout(location = 0) out vec4 shadertoyColor;
const mat2 TURN = mat2(0.8, 0.6, -0.6, 0.8);

float hash(vec2 p) {
    return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453);
}

float noise(vec2 p) {
    vec2 i = floor(p);
    vec2 f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    float low = mix(hash(i), hash(i + vec2(1.0, 0.0)), f.x);
    return mix(low, mix(hash(i + vec2(0.0, 1.0)), hash(i + 1.0), f.x), f.y);
}

float fbm(vec2 p) {
    float sum = 0.0;
    float weight = 0.5;
    for (int i = 0; i < 4; i++) {
        sum += weight * noise(p);
        p = 2.03 * (TURN * p);
        weight *= 0.5;
    }
    return sum;
}

void sc_mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float horizon = 0.35 + 0.02 * textureLod(iChannel0, vec2(uv.x, 0.5), 0.0).x;
    sc_payload = smoothstep(0.35, 0.8, fbm(5.0 * uv));
    vec3 sky = mix(vec3(0.3, 0.5, 0.8), vec3(1.0), sc_payload);
    if (uv.y > horizon) {
        fragColor = vec4(sky, 1.0);
        return;
    }
    float depth = 1.0 / (horizon + 0.01 - uv.y);
    float waves = fbm(vec2(uv.x * depth, depth + 2.0 * iTime));
    fragColor = vec4(mix(vec3(0.0, 0.2, 0.3), sky, 0.5 * waves), 1.0);
}

void sc_shade() {
    sc_mainImage(shadertoyColor, gl_FragCoord.xy);
}

// What is stored of the payloads.
vec4 sc_pack() {
    return vec4(sc_payload, 0.0, 0.0, 16.0 * gl_FragCoord.w);
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

// Two passes, second: the whole shader, for the pixels that the first pass left open.
void main() {
    sc_shade();
    sc_store = sc_pack();
    sc_guard();
}
