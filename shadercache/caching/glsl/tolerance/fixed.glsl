// The same everywhere: of one texel, and roughly of each of several.

float sc_TOLERANCE() {
    return sc_epsilon / sc_UNIT();
}

float sc_ROUGHLY() {
    return sc_SPREAD * sc_EPSILON;
}
