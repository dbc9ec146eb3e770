// 1/w, times 16: half floats are as precise as that from w = 2.4e-4 to 2.6e5; of 1/w only up to
// w = 1.6e4.

float sc_CLIP_DEPTH() {
    return 16.0 / sc_current.w;
}

float sc_PIXEL_DEPTH() {
    return 16.0 * gl_FragCoord.w;
}

float sc_EXPECTED() {
    return 16.0 / sc_previous.w;
}

float sc_OFF(float kept) {
    return 0.0625 * sc_previous.w * kept - 1.0;
}

float sc_CLIP_UNIT() {
    return 16.0 / sc_previous.w;
}

float sc_CURRENT_UNIT() {
    return 16.0 / sc_current.w;
}

float sc_PIXEL_UNIT() {
    return 16.0 * gl_FragCoord.w;
}

float sc_CLIP_ROUNDING() {
    return sc_resolution;
}

float sc_PIXEL_ROUNDING() {
    return sc_resolution;
}
