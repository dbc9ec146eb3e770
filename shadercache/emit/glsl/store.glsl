// What a pass writes into the cache: the payload, padded to three channels, and 1/w; what does not
// fit there goes to the second texture.

in vec4 sc_current;  // clip-space position in this frame
out SC_TEXEL sc_store;  // the texel of the cache
#if SC_TARGETS == 2
out SC_TEXEL sc_store_2;
#endif

SC_PAYLOAD sc_payload;

SC_TEXEL sc_texel() {
    return SC_TEXEL(SC_PACKED_1, SC_INVERSE_W);
}

#if SC_TARGETS == 2
SC_TEXEL sc_texel_2() {
    return SC_TEXEL(SC_PACKED_2);
}
#endif
