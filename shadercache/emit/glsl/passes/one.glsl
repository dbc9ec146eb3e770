// One pass: reuse the payload or compute it, then shade.
void main() {
    sc_fetch_ahead();
    SC_DECLARE_TEXELS;
    if (sc_look_up(SC_TEXELS) == SC_HIT) {
        sc_payload = SC_UNPACKED;
    } else {
        sc_compute();
    }
    sc_shade();
    SC_STORE;
}
