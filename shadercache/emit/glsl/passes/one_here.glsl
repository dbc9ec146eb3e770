// One pass: take the payload from the cache or compute it where it is needed, if it is.
void main() {
    DECLARE_TEXELS;
    sc_reuse = sc_look_up(TEXELS) == SC_HIT;
    sc_valid = sc_reuse;
    sc_payload = UNPACKED;
    sc_shade();
    STORE;
}
