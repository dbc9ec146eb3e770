// What the tests have let pass, made of all texels or of a part of them.

int sc_FOUND(bool marked, sc_TEXELS sc_texel) {
    sc_moved = marked;
    return sc_hit;
}
