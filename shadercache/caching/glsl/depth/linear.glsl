// w, the distance along the view.

float sc_CLIP_DEPTH() {
    return sc_current.w;
}

float sc_PIXEL_DEPTH() {
    return 1.0 / gl_FragCoord.w;
}

float sc_EXPECTED() {
    return sc_previous.w;
}

float sc_OFF(float kept) {
    return kept / sc_previous.w - 1.0;
}

float sc_CLIP_UNIT() {
    return sc_previous.w;
}

float sc_CURRENT_UNIT() {
    return sc_current.w;
}

float sc_PIXEL_UNIT() {
    return 1.0 / gl_FragCoord.w;
}

float sc_CLIP_ROUNDING() {
    return sc_resolution;
}

float sc_PIXEL_ROUNDING() {
    return sc_resolution;
}
