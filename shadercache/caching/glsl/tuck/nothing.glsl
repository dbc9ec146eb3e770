// Offsets lie in channels of their own, or there are none.

sc_TEXEL sc_BARE(sc_TEXEL texel) {
    return texel;
}

sc_TEXEL sc_CLEAN(sc_TEXEL texel) {
    return texel;
}
