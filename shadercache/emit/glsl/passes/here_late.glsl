// Two passes, first: shade whatever has its payload or does not need it; the rest is left open. The
// shading takes derivatives, which are undefined behind a discard, so the discard comes last.
void main() {
    sc_TEXELS sc_texel;
    sc_reuse = sc_look_up(sc_texel) == sc_hit;
    sc_SET_VALID(sc_reuse);
    sc_COMBINE();
    sc_shade();
    sc_STORE(sc_reuse);
    if (sc_lacks) {
        discard;
    }
}
