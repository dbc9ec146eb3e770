// A payload for every pixel.

ivec2 sc_OWN_TEXEL() {
    return ivec2(gl_FragCoord.xy);
}
