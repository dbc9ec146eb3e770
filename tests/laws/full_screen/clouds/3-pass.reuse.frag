#version 330
// shadercache: 3-pass.reuse, node mainImage.23-b73a27b8

// A Shadertoy of our own: clouds that stand still above a sea that moves. Of the clouds nothing
// depends on iTime, so the value of the same pixel stays right for ever.

// What a look-up says. All but a hit are misses; the hit mask shows which.
const int sc_hit = 1;
const int sc_refresh = 2; // computed anew on purpose
const int sc_miss_depth = 4; // another surface was seen there
const int sc_miss_poison = 6; // what was stored must not be reused
const float sc_poison_depth = -65504.0; // depth of what must not be reused
uniform int sc_clock; // frames, already reduced to [0, sc_period)
uniform int sc_period; // frames from one refresh of a pixel to the next
uniform int sc_block; // edge, even, of the squares of pixels that take turns: on 2x2 quads
uniform sampler2D sc_cache; // what the previous frame stored: payload and depth
uniform float sc_epsilon; // greatest accepted difference of depths, relative to the depth
layout(location = 0) out vec4 sc_store; // what the next frame finds in the cache
float sc_payload;

// A well mixed 32-bit hash.
uint sc_hash(uint x) {
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    x *= 0x9E3779B9u;
    return x ^ x >> 15;
}

// A hash made uniform in [0, sc_period).
int sc_residue(uint hashed) {
    return int((hashed >> 16) * uint(sc_period) >> 16);
}

// One round of a shuffle of [0, sc_period) by swaps, each made or not (Hoang, Morris and Rogaway
// 2012): for any period, without a table.
int sc_swap(int slot, int partner, uint key) {
    int other = partner - slot;
    other += other < 0 ? sc_period : 0;
    return ((key + uint(max(slot, other))) * 0x9E3779B9u & 0x80000000u) == 0u ? slot : other;
}

// The frame of each period in which the pixel's turn comes.
int sc_turn() {
    // Blocks are numbered row by row, which is less to compute than groups as high as wide, and as
    // floats: exact below 2^23 blocks, and above them a pixel still has one turn in each period.
    float shrink = 1.0 / float(sc_block);
    vec2 block = floor(gl_FragCoord.xy * shrink);
    float across = ceil((float(textureSize(sc_cache, 0).x) - 0.5) * shrink);
    float number = block.y * across + block.x;
    float group = floor((number + 0.5) / float(sc_period));
    uint key = sc_hash(uint(group) * 9277u + 26699u);
    // Turned by a number of the group's own as well: one swap in four is none, and the places that
    // keep their turn must not stand one above the other.
    int turn = int(number - group * float(sc_period)) + sc_residue(key * 0xC2B2AE35u);
    turn -= turn >= sc_period ? sc_period : 0;
    turn = sc_swap(turn, sc_residue(key), key);
    return sc_swap(turn, sc_residue(key << 16), key ^ 0x85EBCA6Bu);
}

// (turn + clock) mod period == 0: no remainder is taken, since both are in [0, period).
bool sc_due() {
    int phase = sc_turn() + sc_clock;
    return phase == 0 || phase == sc_period;
}

// Where the previous frame holds what the pixel shows, whether that may be reused, and what it is.
int sc_look_up(out vec4 sc_texel) {
    ivec2 near = ivec2(gl_FragCoord.xy);
    sc_texel = textureLod(sc_cache, (vec2(near) + 0.5) / vec2(textureSize(sc_cache, 0)), 0.0);
    if (sc_due()) {
        return sc_refresh;
    }
    // A comparison with NaN is false and so a miss.
    if (!(abs(sc_texel.w - 16.0 * gl_FragCoord.w) <= sc_epsilon * (16.0 * gl_FragCoord.w))) {
        return sc_texel.w == sc_poison_depth ? sc_miss_poison : sc_miss_depth;
    }
    return sc_hit;
}

// What is stored of the payloads.
vec4 sc_pack() {
    return vec4(sc_payload, 0.0, 0.0, 16.0 * gl_FragCoord.w);
}

// Three passes, first: carry the payload of hits over, leave misses open; and discard what the shader
// discards.
void main() {
    vec4 sc_texel;
    if (sc_look_up(sc_texel) != sc_hit) {
        discard;
    }
    sc_payload = sc_texel.x;
    sc_store = sc_pack();
}
