// Three passes, first: carry the payload of hits over, leave misses open; and discard what the shader
// discards. That takes derivatives, which are undefined behind a discard, so the misses come last.
void main() {
    sc_TEXELS sc_texel;
    sc_lacks = sc_look_up(sc_texel) != sc_hit;
    sc_COMBINE();
    sc_PASS_THROUGH();
    sc_STORE_REUSED();
    if (sc_lacks) {
        discard;
    }
}
