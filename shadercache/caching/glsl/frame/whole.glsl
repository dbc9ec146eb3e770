// What is drawn fills its target in every frame.

ivec2 sc_LAST() {
    return textureSize(sc_cache, 0) - 1;
}

ivec2 sc_FIRST() {
    return ivec2(0);
}

int sc_FIRST_COLUMN() {
    return 0;
}

int sc_FIRST_ROW() {
    return 0;
}

vec2 sc_LOWEST() {
    return vec2(0.0);
}

vec2 sc_EXTENT(ivec2 last) {
    return vec2(last + 1);
}

vec2 sc_PIXEL() {
    return gl_FragCoord.xy;
}

vec2 sc_OWN_PLACE(ivec2 last) {
    return 2.0 * gl_FragCoord.xy / vec2(last + 1) - 1.0;
}
