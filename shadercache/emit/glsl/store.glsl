// What a pass writes into the cache: the payload, padded to three channels, and 1/w; what does not
// fit there goes to the second texture. Where not every fragment has a payload (SC_WHOLE) a texel may
// be empty, which matches nothing.

#if SC_SURFACE
in vec4 sc_current;  // clip-space position in this frame
#elif SC_OWN_CURRENT
vec4 sc_current;  // the same, by the user's function
#endif
out SC_TEXEL sc_store;  // the texel of the cache
#if SC_TARGETS == 2
out SC_TEXEL sc_store_2;
#endif

SC_PAYLOAD sc_payload;
#if SC_WHOLE
bool sc_reuse = false;  // is there a payload from the cache?
bool sc_valid = false;  // is there a payload to store?
bool sc_lacks = false;  // was a payload needed, and none there?
#endif

SC_TEXEL sc_texel() {
#if SC_WHOLE
    if (!sc_valid) {
        return SC_EMPTY;
    }
#endif
    return SC_TEXEL(SC_PACKED_1, SC_INVERSE_W);
}

#if SC_TARGETS == 2
SC_TEXEL sc_texel_2() {
#if SC_WHOLE
    if (!sc_valid) {
        return SC_TEXEL(0);
    }
#endif
    return SC_TEXEL(SC_PACKED_2);
}
#endif
