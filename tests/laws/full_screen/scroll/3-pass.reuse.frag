#version 300 es
// shadercache: 3-pass.reuse, node main.20-0b86b19f

precision mediump float;
uniform highp int sc_clock;
uniform highp int sc_period;
uniform highp int sc_block;
uniform highp sampler2D sc_cache;
uniform highp float sc_epsilon;
highp float sc_payload;
bool sc_moved = false;
layout(location = 0) out highp vec4 sc_store;

// A flat pattern that scrolls to the left: only where it was is said, not where the pixel is.
uniform highp vec2 u_resolution;
uniform highp float u_time;
uniform highp float u_time_delta;
const highp float SPEED = 0.7;

highp vec2 place(highp float time) {
    return 2.0 * gl_FragCoord.xy / u_resolution - 1.0 + vec2(SPEED * time, 0.0);
}

highp vec4 scPreviousClip() {
    return vec4(place(u_time) - vec2(SPEED * (u_time - u_time_delta), 0.0), 0.0, 1.0);
}

highp uint sc_hash(highp uint x) {
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    x *= 0x9E3779B9u;
    return x ^ x >> 15;
}

highp int sc_residue(highp uint hashed) {
    return int((hashed >> 16) * uint(sc_period) >> 16);
}

highp int sc_swap(highp int slot, highp int partner, highp uint key) {
    highp int other = partner - slot;
    other += other < 0 ? sc_period : 0;
    return ((key + uint(max(slot, other))) * 0x9E3779B9u & 0x80000000u) == 0u ? slot : other;
}

highp int sc_turn() {
    highp float shrink = 1.0 / float(sc_block);
    highp vec2 block = floor(gl_FragCoord.xy * shrink);
    highp float across = ceil((float(textureSize(sc_cache, 0).x) - 0.5) * shrink);
    highp float number = block.y * across + block.x;
    highp float group = floor((number + 0.5) / float(sc_period));
    highp uint key = sc_hash(uint(group) * 9277u + 26699u);
    highp int turn = int(number - group * float(sc_period)) + sc_residue(key * 0xC2B2AE35u);
    turn -= turn >= sc_period ? sc_period : 0;
    turn = sc_swap(turn, sc_residue(key), key);
    return sc_swap(turn, sc_residue(key << 16), key ^ 0x85EBCA6Bu);
}

bool sc_due() {
    highp int phase = sc_turn() + sc_clock;
    return phase == 0 || phase == sc_period;
}

highp vec4 sc_chosen(highp vec4 a, highp vec4 b, highp vec4 c, highp vec4 d, highp vec4 weights) {
    highp vec4 sum = weights.x > 0.0 ? weights.x * a : vec4(0.0);
    sum += weights.y > 0.0 ? weights.y * b : vec4(0.0);
    sum += weights.z > 0.0 ? weights.z * c : vec4(0.0);
    return sum + (weights.w > 0.0 ? weights.w * d : vec4(0.0));
}

highp int sc_look_up(out highp vec4 texel) {
    highp ivec2 last = textureSize(sc_cache, 0) - 1;
    highp vec4 sc_previous = scPreviousClip();
    highp vec2 motion = sc_previous.xy / sc_previous.w - (2.0 * gl_FragCoord.xy / vec2(last + 1) - 1.0);
    if (all(lessThan(0.5 * vec2(last + 1) * abs(motion), vec2(1.0 / 256.0)))) {
        motion = vec2(0.0);
    }
    highp vec2 corner = gl_FragCoord.xy - 0.5 + 0.5 * vec2(last + 1) * motion;
    highp vec2 slope = vec2(dFdx(16.0 / sc_previous.w), dFdy(16.0 / sc_previous.w)) / (16.0 / sc_previous.w);
    highp vec2 whole = floor(corner);
    highp vec2 part = corner - whole;
    highp ivec2 near = clamp(ivec2(whole), ivec2(0), last);
    highp ivec2 far = min(near + ivec2(ceil(part)), last);
    highp vec4 a = texelFetch(sc_cache, near, 0);
    highp vec4 b = texelFetch(sc_cache, ivec2(far.x, near.y), 0);
    highp vec4 c = texelFetch(sc_cache, ivec2(near.x, far.y), 0);
    highp vec4 d = texelFetch(sc_cache, far, 0);
    texel = mix(mix(a, b, part.x), mix(c, d, part.x), part.y);
    if (sc_due()) {
        return 2;
    }
    if (!(sc_previous.w > 0.0 && all(greaterThanEqual(corner, vec2(0.0))) && all(lessThanEqual(corner, vec2(last))))) {
        return 3;
    }
    highp vec4 aside = 0.0625 * sc_previous.w * abs(vec4(a.w, b.w, c.w, d.w)) - 1.0 - slope.x * vec4(-part.x, 1.0 - part.x, -part.x, 1.0 - part.x) - slope.y * vec4(-part.y, -part.y, 1.0 - part.y, 1.0 - part.y);
    bvec4 moved = lessThan(vec4(a.w, b.w, c.w, d.w), vec4(0.0));
    highp vec4 single = vec4(lessThanEqual(abs(aside), vec4(sc_epsilon))) * vec4(not(moved));
    highp vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.y, 1.0 - part.y, part.y, part.y);
    highp float blended = dot(weights, abs(vec4(a.w, b.w, c.w, d.w)));
    bool one_surface = all(lessThanEqual(abs(0.0625 * sc_previous.w * abs(vec4(a.w, b.w, c.w, d.w)) - 1.0), vec4(24.0 * sc_epsilon)));
    bool agrees = one_surface && abs(0.0625 * sc_previous.w * blended - 1.0) <= sc_epsilon;
    if (one_surface && !agrees) {
        return 4;
    }
    bool marked = dot(weights, vec4(moved)) > 0.0;
    if (!agrees) {
        weights *= single;
        highp float total = dot(weights, vec4(1.0));
        if (!(total >= 0.25)) {
            return a.w == -65504.0 || b.w == -65504.0 || c.w == -65504.0 || d.w == -65504.0 ? 6 : 4;
        }
        weights /= total;
        texel = sc_chosen(a, b, c, d, weights);
        marked = true;
    }
    sc_moved = marked;
    return 1;
}

highp vec4 sc_texel() {
    return vec4(sc_payload, 0.0, 0.0, sc_moved ? -(16.0 * gl_FragCoord.w) : 16.0 * gl_FragCoord.w);
}

void main() {
    highp vec4 texel;
    if (sc_look_up(texel) != 1) {
        discard;
    }
    sc_payload = texel.x;
    sc_store = sc_texel();
}
