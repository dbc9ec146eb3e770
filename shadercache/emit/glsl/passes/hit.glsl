// Two passes, first: shade hits from the payload, leave misses open.
void main() {
    sc_TEXELS sc_texel;
    if (sc_look_up(sc_texel) != sc_hit) {
        discard;
    }
    sc_COMBINE();
    sc_shade();
    sc_STORE_REUSED();
}
