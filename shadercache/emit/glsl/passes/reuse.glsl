// Three passes, first: carry the payload of hits over, leave misses open; and discard what the shader
// discards.
void main() {
    sc_TEXELS sc_texel;
    if (sc_look_up(sc_texel) != sc_hit) {
        discard;
    }
    sc_COMBINE();
    sc_PASS_THROUGH();
    sc_STORE_REUSED();
}
