#version 330
// shadercache: 1-pass, node mainImage.23-b73a27b8

// A Shadertoy of our own: clouds that stand still above a sea that moves. Of the clouds nothing
// depends on iTime, so the value of the same pixel stays right for ever.

vec4 sc_color;
uniform int sc_clock;
uniform int sc_period;
uniform int sc_block;
uniform sampler2D sc_cache;
uniform float sc_epsilon;
float sc_payload;
bool sc_moved = false;
layout(location = 1) out vec4 sc_store;
uniform float sc_limit;
uniform float sc_least;
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
    sc_payload = smoothstep(0.35, 0.8, fbm(5.0 * uv));
}

void sc_mainImage_1(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float horizon = 0.35 + 0.02 * textureLod(iChannel0, vec2(uv.x, 0.5), 0.0).x;
    vec3 sky = mix(vec3(0.3, 0.5, 0.8), vec3(1.0), sc_payload);
    if (uv.y > horizon) {
        fragColor = vec4(sky, 1.0);
        return;
    }
    float depth = 1.0 / (horizon + 0.01 - uv.y);
    float waves = fbm(vec2(uv.x * depth, depth + 2.0 * iTime));
    fragColor = vec4(mix(vec3(0.0, 0.2, 0.3), sky, 0.5 * waves), 1.0);
}

void sc_compute() {
    sc_mainImage(sc_color, gl_FragCoord.xy);
}

void sc_shade() {
    sc_mainImage_1(shadertoyColor, gl_FragCoord.xy);
}

uint sc_hash(uint x) {
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    x *= 0x9E3779B9u;
    return x ^ x >> 15;
}

int sc_residue(uint hashed) {
    return int((hashed >> 16) * uint(sc_period) >> 16);
}

int sc_swap(int slot, int partner, uint key) {
    int other = partner - slot;
    other += other < 0 ? sc_period : 0;
    return ((key + uint(max(slot, other))) * 0x9E3779B9u & 0x80000000u) == 0u ? slot : other;
}

int sc_turn() {
    float shrink = 1.0 / float(sc_block);
    vec2 block = floor(gl_FragCoord.xy * shrink);
    float across = ceil((float(textureSize(sc_cache, 0).x) - 0.5) * shrink);
    float number = block.y * across + block.x;
    float group = floor((number + 0.5) / float(sc_period));
    uint key = sc_hash(uint(group) * 9277u + 26699u);
    int turn = int(number - group * float(sc_period)) + sc_residue(key * 0xC2B2AE35u);
    turn -= turn >= sc_period ? sc_period : 0;
    turn = sc_swap(turn, sc_residue(key), key);
    return sc_swap(turn, sc_residue(key << 16), key ^ 0x85EBCA6Bu);
}

bool sc_due() {
    int phase = sc_turn() + sc_clock;
    return phase == 0 || phase == sc_period;
}

int sc_look_up(out vec4 texel) {
    ivec2 own = ivec2(gl_FragCoord.xy);
    texel = texelFetch(sc_cache, own, 0);
    if (sc_due()) {
        return 2;
    }
    if (!(abs(texel.w - 16.0 * gl_FragCoord.w) <= sc_epsilon * (16.0 * gl_FragCoord.w))) {
        return texel.w == -65504.0 ? 6 : 4;
    }
    return 1;
}

vec4 sc_texel() {
    return vec4(sc_payload, 0.0, 0.0, sc_moved ? -(16.0 * gl_FragCoord.w) : 16.0 * gl_FragCoord.w);
}

vec4 sc_held(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    vec4 held = mix(clamp(values, vec4(-sc_limit), vec4(sc_limit)), values, greaterThanEqual(sizes, uvec4(0x7F800000u)));
    return mix(values, held, greaterThan(sizes, uvec4(floatBitsToUint(sc_limit))));
}

void sc_hold() {
    if (sc_limit <= 65504.0) {
        sc_store = sc_held(sc_store);
    }
}

bool sc_unfit(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    return any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit)))) || any(lessThan(sizes - 1u, uvec4(least)));
}

void sc_guard() {
    bool unfit = sc_unfit(sc_store);
    if (unfit) {
        sc_hold();
        sc_store.w = -65504.0;
    }
}

void main() {
    vec4 texel;
    bool sc_hit = sc_look_up(texel) == 1;
    if (sc_hit) {
        sc_payload = texel.x;
    } else {
        sc_compute();
    }
    sc_shade();
    sc_store = sc_texel();
    if (!sc_hit) {
        sc_guard();
    }
}
