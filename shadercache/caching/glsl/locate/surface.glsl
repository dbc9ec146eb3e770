// Where the pixel's point of the surface was in the previous frame.

in vec4 sc_current;   // clip-space position in this frame
in vec4 sc_previous;  // clip-space position of the same surface point in the previous frame

void sc_MOTION(ivec2 last, out vec2 motion) {
    motion = sc_previous.xy / sc_previous.w - sc_current.xy / sc_current.w;
}

void sc_HERE() {
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
    return sc_PIXEL_DEPTH();
}

float sc_SEEN_UNIT() {
    return sc_PIXEL_UNIT();
}
