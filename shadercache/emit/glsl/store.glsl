// What a pass writes into the cache: the payloads, padded to three channels, and 1/w; what does not
// fit there goes to the second texture. Where not every fragment has a payload (SC_WHOLE) a texel may
// be empty, which matches nothing; so does one that lacks one of several payloads (SC_MASKED).

#if SC_SURFACE
in vec4 sc_current;  // clip-space position in this frame
#elif SC_OWN_CURRENT
vec4 sc_current;  // the same, by the user's function
#endif
out SC_TEXEL sc_store;  // the texel of the cache
#if SC_TARGETS == 2
out SC_TEXEL sc_store_2;
#endif

#if SC_IDS
uniform int sc_object;  // number of the object that is drawn
#endif

#if SC_AGE
uniform int sc_reset;   // 1 in a frame that follows a reset, else 0
uniform int sc_period;  // frames between two refreshes of a pixel
uniform int sc_block;   // edge in pixels of the squares that are refreshed together
float sc_age = 0.0;     // frames since the payload was computed

// After a reset all payloads are new. They start with different ages, or all would be too old in the
// same frame.
void sc_stagger() {
    if (sc_reset != 0) {
        uvec2 block = uvec2(gl_FragCoord.xy / float(sc_block));
        uint hashed = (block.x * 1973u + block.y * 9277u + 26699u) * 0x9E3779B9u;
        hashed = (hashed ^ (hashed >> 15)) * 0x85EBCA6Bu;
        sc_age = float(((hashed >> 16) * uint(sc_period)) >> 16);
    }
}
#endif

SC_DECLARE_PAYLOADS;
#if SC_WHOLE
bool sc_reuse = false;  // are there payloads from the cache?
SC_DECLARE_VALID;       // is there a payload to store?
#endif
bool sc_lacks = false;  // was a payload needed, and none there?

SC_TEXEL sc_texel() {
#if SC_MASKED
    // The third of three passes takes from here what there is; the next frame needs all or nothing.
    return SC_TEXEL(SC_PACKED_1, SC_VALID ? SC_INVERSE_W : SC_NO_DEPTH);
#else
#if SC_WHOLE
    if (!SC_VALID) {
        return SC_EMPTY;
    }
#endif
    return SC_TEXEL(SC_PACKED_1, SC_INVERSE_W);
#endif
}

#if SC_TARGETS == 2
SC_TEXEL sc_texel_2() {
#if SC_WHOLE && !SC_MASKED
    if (!SC_VALID) {
        return SC_TEXEL(0);
    }
#endif
    return SC_TEXEL(SC_PACKED_2);
}
#endif
