// What the tests have let pass, if the sample that is kept of it is not too old.

int sc_FOUND(bool marked, sc_TEXELS sc_texel) {
    int outcome = sc_RAW_VERDICT();
    // What is computed instead lies in the middle.
    sc_offset = outcome == sc_hit ? sc_offset : vec2(0.0);
    return outcome;
}
