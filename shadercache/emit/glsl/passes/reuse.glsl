// Three passes, first: carry the payload of hits over, leave misses open; and discard what the shader
// discards.
void main() {
    SC_DECLARE_TEXELS;
    if (sc_look_up(SC_TEXELS) != SC_HIT) {
        discard;
    }
    sc_payload = SC_UNPACKED;
#if SC_WHOLE
    sc_valid = true;
    sc_shade();
#endif
    SC_STORE;
}
