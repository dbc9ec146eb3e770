// The pixel itself, whatever it showed in the previous frame.

void sc_LOCATE(out ivec2 last, out vec2 place, out vec4 jacobian, out vec2 slope) {
}

void sc_HERE() {
}

float sc_DEPTH() {
    return sc_PIXEL_DEPTH();
}

float sc_UNIT() {
    return sc_PIXEL_UNIT();
}

float sc_ROUNDING() {
    return sc_PIXEL_ROUNDING();
}

float sc_SEEN_DEPTH() {
    return sc_PIXEL_DEPTH();
}

float sc_SEEN_UNIT() {
    return sc_PIXEL_UNIT();
}
