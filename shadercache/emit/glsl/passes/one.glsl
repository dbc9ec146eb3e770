// One pass: reuse the payload or compute it, then shade.
void main() {
    sc_fetch_ahead();
    DECLARE_TEXELS;
    if (sc_look_up(TEXELS) == SC_HIT) {
        sc_payload = UNPACKED;
    } else {
        sc_compute();
    }
    sc_shade();
    STORE;
}
