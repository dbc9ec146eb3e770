// Where functions of the user's say that the pixel is, and was in the previous frame.

vec4 sc_current;  // clip-space position in this frame

void sc_MOTION(ivec2 last, out vec2 motion) {
    sc_current = scCurrentClip();
    vec4 sc_previous = scPreviousClip();
    motion = sc_previous.xy / sc_previous.w - sc_current.xy / sc_current.w;
}

void sc_HERE() {
    sc_current = scCurrentClip();
}

float sc_DEPTH() {
    return sc_CLIP_DEPTH();
}

float sc_UNIT() {
    return sc_CLIP_UNIT();
}

float sc_ROUNDING() {
    return sc_CLIP_ROUNDING();
}

float sc_SEEN_DEPTH() {
    return sc_CLIP_DEPTH();
}

float sc_SEEN_UNIT() {
    return sc_CURRENT_UNIT();
}
