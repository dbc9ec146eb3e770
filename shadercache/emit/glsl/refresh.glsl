// Which pixels are recomputed on purpose, although the cache holds what they need. Words in capitals:
// see macros.glsl and CacheOptions.

#if SC_REFRESH_NONE
bool sc_due() {
    return false;
}
#else
uniform int sc_clock;   // frames, already reduced to [0, sc_period)
uniform int sc_period;  // frames between two refreshes of a pixel
uniform int sc_block;   // edge in pixels of the squares that are refreshed together

// A well mixed 32-bit hash of a block's coordinates.
uint sc_hash(uvec2 block) {
    uint x = block.x * 1973u + block.y * 9277u + 26699u;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    x *= 0x9E3779B9u;
    return x ^ (x >> 15);
}

// (h + clock) mod period == 0 with h uniform in [0, period): no remainder is taken, since
// 0 <= h + clock < 2 * period. The blocks lie on multiples of sc_block, so on 2x2 quads.
bool sc_due() {
    uvec2 block = uvec2(gl_FragCoord.xy / float(sc_block));
    int h = int(((sc_hash(block) >> 16) * uint(sc_period)) >> 16);
    int phase = h + sc_clock;
    return phase == 0 || phase == sc_period;
}
#endif
