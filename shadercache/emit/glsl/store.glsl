// What a pass writes into the cache: the payload, padded to three channels, and 1/w; what does not
// fit there goes to the second texture.

in vec4 sc_current;  // clip-space position in this frame
out TEXEL sc_store;  // the texel of the cache
#if SC_TARGETS == 2
out TEXEL sc_store_2;
#endif

PAYLOAD sc_payload;

TEXEL sc_texel() {
    return TEXEL(PACKED_1, DEPTH);
}

#if SC_TARGETS == 2
TEXEL sc_texel_2() {
    return TEXEL(PACKED_2);
}
#endif
