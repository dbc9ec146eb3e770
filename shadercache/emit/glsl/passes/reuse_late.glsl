// Three passes, first: carry the payload of hits over, leave misses open; and discard what the shader
// discards. That takes derivatives, which are undefined behind a discard, so the misses come last.
void main() {
    SC_DECLARE_TEXELS;
    sc_lacks = sc_look_up(SC_TEXELS) != SC_HIT;
    SC_UNPACK;
    SC_SET_VALID(true);
    sc_shade();
    SC_STORE_AGAIN;
    if (sc_lacks) {
        discard;
    }
}
