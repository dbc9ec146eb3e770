// Two passes, first: shade hits from the payload, leave misses open. The shading takes derivatives,
// which are undefined behind a discard, so the discard comes last.
void main() {
    sc_TEXELS sc_texel;
    sc_lacks = sc_look_up(sc_texel) != sc_hit;
    sc_COMBINE();
    sc_shade();
    sc_STORE_REUSED();
    if (sc_lacks) {
        discard;
    }
}
