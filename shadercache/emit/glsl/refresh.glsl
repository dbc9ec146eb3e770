// Which pixels are recomputed on purpose, although the cache holds what they need. Words in capitals:
// see macros.glsl and CacheOptions.

#if SC_REFRESH_NONE
bool sc_due() {
    return false;
}
#else
uniform int sc_clock;   // frames, already reduced to [0, sc_period)
uniform int sc_period;  // frames between two refreshes of a pixel
#if !SC_REFRESH_SURFACE
uniform int sc_block;   // edge in pixels of the squares that are refreshed together
#endif
#if SC_REFRESH_STRATIFIED || SC_REFRESH_TILED
uniform SC_SAMPLER sc_cache;  // as large as the picture
#endif

// A well mixed 32-bit hash.
uint sc_hash(uint x) {
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    x *= 0x9E3779B9u;
    return x ^ (x >> 15);
}

// A hash made uniform in [0, sc_period).
int sc_residue(uint hashed) {
    return int(((hashed >> 16) * uint(sc_period)) >> 16);
}

#if SC_REFRESH_TILED
// The picture in blocks. Numbers are divided as floats, with half of one added, so that no rounding
// can matter: many renderers divide integers slowly.
vec2 sc_blocks() {
    return floor((vec2(textureSize(sc_cache, 0) + sc_block) - 0.5) / float(sc_block));
}

// The pixel's block, numbered from 0 without gaps: strips that are `tall` blocks high, one above the
// other, and in each column after column. So neighbours in number are neighbours in the picture.
int sc_number(vec2 blocks, float tall) {
    vec2 block = floor(gl_FragCoord.xy / float(sc_block));
    float bottom = floor((block.y + 0.5) / tall) * tall;
    float column = min(tall, blocks.y - bottom);
    return int(bottom) * int(blocks.x) + int(block.x * column + block.y - bottom);
}
#endif

#if SC_REFRESH_STRATIFIED
// One round of a shuffle of [0, sc_period) by swaps, each made or not (Hoang, Morris and Rogaway
// 2012): for any period, without a table.
int sc_swap(int slot, int partner, uint key) {
    int other = partner - slot;
    other += other < 0 ? sc_period : 0;
    return ((key + uint(max(slot, other))) * 0x9E3779B9u & 0x80000000u) == 0u ? slot : other;
}
#endif

// The frame of each period in which the pixel's turn comes.
int sc_turn() {
#if SC_REFRESH_RANDOM
    uvec2 block = uvec2(gl_FragCoord.xy / float(sc_block));
    return sc_residue(sc_hash(block.x * 1973u + block.y * 9277u + 26699u));
#elif SC_REFRESH_STRATIFIED
    // Of each group of sc_period blocks one is due in every frame, in an order of the group's own.
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
#elif SC_REFRESH_TILED
    // As many tiles as there are frames in a period, each due in one of them.
    vec2 blocks = sc_blocks();
    float tile = ceil((blocks.x * blocks.y - 0.5) / float(sc_period));
    return int((float(sc_number(blocks, floor(sqrt(tile) + 0.01))) + 0.5) / tile);
#elif SC_REFRESH_SURFACE
    // Neighbouring triangles of a mesh are drawn one behind the other, so they share a turn.
    return sc_residue(sc_hash(uint(gl_PrimitiveID >> 6) * 9277u + 26699u));
#endif
}

// (turn + clock) mod period == 0: no remainder is taken, since both are in [0, period). Blocks lie
// on multiples of sc_block, so on 2x2 quads.
bool sc_due() {
    int phase = sc_turn() + sc_clock;
    return phase == 0 || phase == sc_period;
}
#endif

#if SC_AGE
#if SC_REFRESH_NONE
uniform int sc_period;  // frames after which a payload is computed again
#endif
float sc_age = 0.0;  // frames since the payload was computed

// May what was `age` frames old in the last frame be reused once more? A payload that is less than
// half a period old misses its turn: it was computed out of turn, and is renewed when it gets too
// old. Returns SC_HIT, SC_REFRESH or SC_OLD.
int sc_judge(float age) {
    // A comparison with NaN is false, so that no such age lives on.
#if SC_REFRESH_NONE
    if (!(age + 1.0 < float(sc_period))) {
        return SC_OLD;
    }
#else
    if (!(age + 1.0 <= float(sc_period))) {
        return SC_OLD;
    }
    if (2.0 * (age + 1.0) >= float(sc_period) && sc_due()) {
        return SC_REFRESH;
    }
#endif
    sc_age = age + 1.0;
    return SC_HIT;
}
#endif
