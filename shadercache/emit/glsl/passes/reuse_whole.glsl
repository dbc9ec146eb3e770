// Three passes, first: carry the payload of hits over, leave misses open; and discard what the shader
// discards.
void main() {
    DECLARE_TEXELS;
    if (sc_look_up(TEXELS) != SC_HIT) {
        discard;
    }
    sc_valid = true;
    sc_payload = UNPACKED;
    sc_shade();
    STORE;
}
