// Three passes, first: carry the payload of hits over, leave misses open.
void main() {
    DECLARE_TEXELS;
    if (sc_look_up(TEXELS) != SC_HIT) {
        discard;
    }
    sc_payload = UNPACKED;
    STORE;
}
