// Two passes, first: shade hits from the payload, leave misses open.
void main() {
    DECLARE_TEXELS;
    if (sc_look_up(TEXELS) != SC_HIT) {
        discard;
    }
    sc_payload = UNPACKED;
    sc_shade();
    STORE;
}
