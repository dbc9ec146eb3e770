// Three passes, first: carry the payload of hits over, leave misses open; and discard what the shader
// discards.
void main() {
    SC_DECLARE_TEXELS;
    if (sc_look_up(SC_TEXELS) != SC_HIT) {
        discard;
    }
    sc_valid = true;
    sc_payload = SC_UNPACKED;
    sc_shade();
    SC_STORE;
}
