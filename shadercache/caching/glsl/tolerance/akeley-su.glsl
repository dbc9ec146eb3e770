// What the stored depth's resolution and the interpolation of positions leave uncertain (Akeley and
// Su 2006): of one texel, and roughly of each of several.

float sc_TOLERANCE() {
    return sc_INTERPOLATION + sc_ROUNDING();
}

float sc_ROUGHLY() {
    return sc_SPREAD * sc_EPSILON;
}
