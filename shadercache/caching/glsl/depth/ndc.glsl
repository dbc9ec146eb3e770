// z/w, from -1 to 1.

float sc_CLIP_DEPTH() {
    return sc_current.z / sc_current.w;
}

float sc_PIXEL_DEPTH() {
    return 2.0 * gl_FragCoord.z - 1.0;
}

float sc_EXPECTED() {
    return sc_previous.z / sc_previous.w;
}

float sc_OFF(float kept) {
    return (kept * sc_previous.w - sc_previous.z) / sc_unit;
}

float sc_CLIP_UNIT() {
    return sc_unit / sc_previous.w;
}

float sc_CURRENT_UNIT() {
    return sc_unit / sc_current.w;
}

float sc_PIXEL_UNIT() {
    return sc_unit * gl_FragCoord.w;
}

float sc_CLIP_ROUNDING() {
    return sc_resolution * abs(sc_previous.z) / sc_unit;
}

float sc_PIXEL_ROUNDING() {
    return sc_resolution / (sc_unit * gl_FragCoord.w);
}
