// Three passes, first: carry the payload of hits over, leave misses open; and discard what the shader
// discards.
void main() {
    SC_DECLARE_TEXELS;
    if (sc_look_up(SC_TEXELS) != SC_HIT) {
        discard;
    }
    SC_UNPACK;
#if SC_WHOLE
    SC_SET_VALID(true);
    sc_shade();
#endif
    SC_STORE_AGAIN;
}
