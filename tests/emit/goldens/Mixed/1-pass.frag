#version 330
// shadercache: 1-pass, node main.11-a0ace7bc

uniform int sc_clock;
uniform int sc_period;
uniform int sc_block;
uniform usampler2D sc_cache;
in vec4 sc_current;
in vec4 sc_previous;
uniform usampler2D sc_cache_2;
uniform float sc_epsilon;
bool sc_moved = false;
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

void sc_compute() {
    vec4 wave = sin(9.0 * v_position.xyzx) * cos(5.0 * v_position.yzxy);
    sc_payload = Mixed(Pair(wave.xy, wave.z), wave.x > 0.3, ivec2(2.0 * wave.yz), uint(3.0 + wave.x));
}

void sc_shade() {
    Mixed it = sc_payload;
    o_color = vec4(0.5 + 0.5 * (vec3(it.pair.a, it.pair.b) * (it.sign ? 1.0 : 0.4) + vec3(it.cell, it.number) / 9.0) * normalize(v_normal).z, 1.0);
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

uvec4 sc_blend(uvec4 a, uvec4 b, uvec4 c, uvec4 d, vec2 part, uvec4 discrete) {
    vec4 low = mix(uintBitsToFloat(a), uintBitsToFloat(b), part.x);
    vec4 high = mix(uintBitsToFloat(c), uintBitsToFloat(d), part.x);
    vec4 blended = mix(low, high, part.y);
    return a & discrete | floatBitsToUint(blended) & ~discrete;
}

bool sc_same(uvec4 a, uvec4 b, uvec4 c, uvec4 d, uvec4 discrete) {
    return ((a ^ b | a ^ c | a ^ d) & discrete) == uvec4(0u);
}

vec4 sc_chosen(vec4 a, vec4 b, vec4 c, vec4 d, vec4 weights) {
    vec4 sum = weights.x > 0.0 ? weights.x * a : vec4(0.0);
    sum += weights.y > 0.0 ? weights.y * b : vec4(0.0);
    sum += weights.z > 0.0 ? weights.z * c : vec4(0.0);
    return sum + (weights.w > 0.0 ? weights.w * d : vec4(0.0));
}

int sc_look_up(out uvec4 texel, out uvec4 texel_2) {
    ivec2 last = textureSize(sc_cache, 0) - 1;
    vec2 motion = sc_previous.xy / sc_previous.w - sc_current.xy / sc_current.w;
    vec2 corner = gl_FragCoord.xy - 0.5 + 0.5 * vec2(last + 1) * motion;
    vec2 slope = vec2(dFdx(16.0 / sc_previous.w), dFdy(16.0 / sc_previous.w)) / (16.0 / sc_previous.w);
    vec2 whole = floor(corner);
    vec2 part = corner - whole;
    ivec2 near = clamp(ivec2(whole), ivec2(0), last);
    ivec2 far = min(near + ivec2(ceil(part)), last);
    uvec4 a = texelFetch(sc_cache, near, 0);
    uvec4 b = texelFetch(sc_cache, ivec2(far.x, near.y), 0);
    uvec4 c = texelFetch(sc_cache, ivec2(near.x, far.y), 0);
    uvec4 d = texelFetch(sc_cache, far, 0);
    uvec4 a_2 = texelFetch(sc_cache_2, near, 0);
    uvec4 b_2 = texelFetch(sc_cache_2, ivec2(far.x, near.y), 0);
    uvec4 c_2 = texelFetch(sc_cache_2, ivec2(near.x, far.y), 0);
    uvec4 d_2 = texelFetch(sc_cache_2, far, 0);
    texel = sc_blend(a, b, c, d, part, uvec4(0u, 0u, 0u, 0u));
    texel_2 = sc_blend(a_2, b_2, c_2, d_2, part, uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu));
    if (sc_due()) {
        return 2;
    }
    if (!(sc_previous.w > 0.0 && all(greaterThanEqual(corner, vec2(0.0))) && all(lessThanEqual(corner, vec2(last))))) {
        return 3;
    }
    vec4 aside = 0.0625 * sc_previous.w * abs(vec4(uintBitsToFloat(a.w), uintBitsToFloat(b.w), uintBitsToFloat(c.w), uintBitsToFloat(d.w))) - 1.0 - slope.x * vec4(-part.x, 1.0 - part.x, -part.x, 1.0 - part.x) - slope.y * vec4(-part.y, -part.y, 1.0 - part.y, 1.0 - part.y);
    bvec4 moved = lessThan(vec4(uintBitsToFloat(a.w), uintBitsToFloat(b.w), uintBitsToFloat(c.w), uintBitsToFloat(d.w)), vec4(0.0));
    vec4 single = vec4(lessThanEqual(abs(aside), vec4(sc_epsilon))) * vec4(not(moved));
    vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.y, 1.0 - part.y, part.y, part.y);
    float blended = dot(weights, abs(vec4(uintBitsToFloat(a.w), uintBitsToFloat(b.w), uintBitsToFloat(c.w), uintBitsToFloat(d.w))));
    bool one_surface = all(lessThanEqual(abs(0.0625 * sc_previous.w * abs(vec4(uintBitsToFloat(a.w), uintBitsToFloat(b.w), uintBitsToFloat(c.w), uintBitsToFloat(d.w))) - 1.0), vec4(24.0 * sc_epsilon)));
    bool agrees = one_surface && abs(0.0625 * sc_previous.w * blended - 1.0) <= sc_epsilon;
    if (one_surface && !agrees) {
        return 4;
    }
    bool marked = dot(weights, vec4(moved)) > 0.0;
    if (!agrees) {
        weights *= single;
        float total = dot(weights, vec4(1.0));
        if (!(total >= 0.25)) {
            return a.w == 0xFF000000u || b.w == 0xFF000000u || c.w == 0xFF000000u || d.w == 0xFF000000u ? 6 : 4;
        }
        weights /= total;
        texel = a & uvec4(0u, 0u, 0u, 0u) | floatBitsToUint(sc_chosen(uintBitsToFloat(a), uintBitsToFloat(b), uintBitsToFloat(c), uintBitsToFloat(d), weights)) & ~uvec4(0u, 0u, 0u, 0u);
        texel_2 = a_2 & uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu) | floatBitsToUint(sc_chosen(uintBitsToFloat(a_2), uintBitsToFloat(b_2), uintBitsToFloat(c_2), uintBitsToFloat(d_2), weights)) & ~uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu);
        marked = true;
    }
    if (!sc_same(a_2, b_2, c_2, d_2, uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu))) {
        return 4;
    }
    sc_moved = marked;
    return 1;
}

uvec4 sc_texel() {
    return uvec4(floatBitsToUint(sc_payload.pair.a), floatBitsToUint(sc_payload.pair.b), floatBitsToUint(16.0 / sc_current.w) | (sc_moved ? 0x80000000u : 0u));
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
    uvec4 sc_local_1;
    uvec4 sc_local_2;
    bool sc_hit = sc_look_up(sc_local_1, sc_local_2) == 1;
    if (sc_hit) {
        sc_payload = Mixed(Pair(uintBitsToFloat(sc_local_1.xy), uintBitsToFloat(sc_local_1.z)), bool(sc_local_2.x), ivec2(sc_local_2.yz), sc_local_2.w);
    } else {
        sc_compute();
    }
    sc_shade();
    sc_store = sc_texel();
    sc_store_2 = sc_texel_2();
    if (!sc_hit) {
        sc_guard();
    }
}
