// What the tests have let pass, made of all texels or of a part of them, if it is not too old.

int sc_FOUND(bool marked, sc_TEXELS sc_texel) {
    int outcome = sc_VERDICT();
    sc_moved = marked && outcome == sc_hit;
    return outcome;
}
