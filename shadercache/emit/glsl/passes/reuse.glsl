// Three passes, first: carry the payload of hits over, leave misses open.
void main() {
    SC_DECLARE_TEXELS;
    if (sc_look_up(SC_TEXELS) != SC_HIT) {
        discard;
    }
    sc_payload = SC_UNPACKED;
    SC_STORE;
}
