// Where a function of the user's says that the pixel was in the previous frame. Where it is now is
// the pixel's own place.

void sc_MOTION(ivec2 last, out vec2 motion) {
    vec4 sc_previous = scPreviousClip();
    motion = sc_previous.xy / sc_previous.w - sc_OWN_PLACE(last);
    // The function comes to the pixel's own place by another way, up to rounding: what is less than
    // a 256th of a pixel is no motion.
    if (all(lessThan(0.5 * sc_EXTENT(last) * abs(motion), vec2(1.0 / 256.0)))) {
        motion = vec2(0.0);
    }
}

void sc_HERE() {
}

float sc_DEPTH() {
    return sc_PIXEL_DEPTH();
}

float sc_UNIT() {
    return sc_CLIP_UNIT();
}

float sc_ROUNDING() {
    return sc_CLIP_ROUNDING();
}

float sc_SEEN_DEPTH() {
    return sc_PIXEL_DEPTH();
}

float sc_SEEN_UNIT() {
    return sc_PIXEL_UNIT();
}
