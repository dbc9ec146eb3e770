// What is drawn fills a viewport, which may be another in each frame.

ivec2 sc_LAST() {
    return sc_previous_viewport.xy + sc_previous_viewport.zw - 1;
}

ivec2 sc_FIRST() {
    return sc_previous_viewport.xy;
}

int sc_FIRST_COLUMN() {
    return sc_previous_viewport.x;
}

int sc_FIRST_ROW() {
    return sc_previous_viewport.y;
}

vec2 sc_LOWEST() {
    return vec2(sc_previous_viewport.xy);
}

vec2 sc_EXTENT(ivec2 last) {
    return vec2(sc_previous_viewport.zw);
}

// The pixel's place in the previous viewport. While that does not change it is exactly its own.
vec2 sc_PIXEL() {
    return (gl_FragCoord.xy - vec2(sc_viewport.xy)) * (vec2(sc_previous_viewport.zw) / vec2(sc_viewport.zw))
        + vec2(sc_previous_viewport.xy);
}

vec2 sc_OWN_PLACE(ivec2 last) {
    return 2.0 * (gl_FragCoord.xy - vec2(sc_viewport.xy)) / vec2(sc_viewport.zw) - 1.0;
}
