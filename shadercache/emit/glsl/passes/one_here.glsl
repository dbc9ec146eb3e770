// One pass: take the payload from the cache or compute it where it is needed, if it is.
void main() {
    SC_DECLARE_TEXELS;
    sc_reuse = sc_look_up(SC_TEXELS) == SC_HIT;
    sc_valid = sc_reuse;
    sc_payload = SC_UNPACKED;
    sc_shade();
    SC_STORE;
}
