// The look-up in the cache of the previous frame, slot by slot. Each of these calls stands for the
// statements of the files that are chosen for its slot; whoever returns ends the look-up.

// Where the previous frame holds what the pixel shows, whether that may be reused, and what it is.
int sc_look_up(out sc_TEXELS sc_texel) {
    sc_LOCATE(last, place, jacobian, slope);
    sc_FETCH(last, place, part, near, a, b, c, d, sc_texel);
    sc_TEST(last, place, jacobian, slope, part, near, a, b, c, d, sc_texel, fits, weights, agrees, marked);
    sc_RESAMPLE(last, part, near, a, b, c, d, fits, weights, agrees, marked, sc_texel);
    sc_FOUND(marked, sc_texel);
}
