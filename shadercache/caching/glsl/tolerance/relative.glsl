// A share of the depth: of one texel, and roughly of each of several.

float sc_TOLERANCE() {
    return sc_epsilon;
}

float sc_ROUGHLY() {
    return sc_SPREAD * sc_epsilon;
}
