// Where not every fragment needs the payload: one pass, which computes it where it stands, or the first
// of two, which shades whatever has its payload or does not need it and leaves the rest open.
void main() {
    sc_TEXELS sc_texel;
    sc_reuse = sc_look_up(sc_texel) == sc_hit;
    sc_SET_VALID(sc_reuse);
    sc_COMBINE();
    sc_shade();
    sc_STORE(sc_reuse);
}
