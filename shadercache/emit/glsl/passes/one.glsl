// One pass: reuse the payload or compute it, then shade.
void main() {
    sc_fetch_ahead();
    SC_DECLARE_TEXELS;
    bool sc_hit = sc_look_up(SC_TEXELS) == SC_HIT;
    if (sc_hit) {
        SC_UNPACK;
    } else {
        sc_compute();
    }
    sc_shade();
    SC_STORE_UNLESS(sc_hit)
}
