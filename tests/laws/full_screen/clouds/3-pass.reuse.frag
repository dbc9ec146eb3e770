#version 330
// shadercache: 3-pass.reuse, node mainImage.23-b73a27b8

// A Shadertoy of our own: clouds that stand still above a sea that moves. Of the clouds nothing
// depends on iTime, so the value of the same pixel stays right for ever.

uniform int sc_clock;
uniform int sc_period;
uniform int sc_block;
uniform sampler2D sc_cache;
uniform float sc_epsilon;
float sc_payload;
bool sc_moved = false;
layout(location = 0) out vec4 sc_store;

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

void main() {
    vec4 texel;
    if (sc_look_up(texel) != 1) {
        discard;
    }
    sc_payload = texel.x;
    sc_store = sc_texel();
}
