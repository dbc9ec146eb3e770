// One pass: reuse the payload or compute it, then shade.
void main() {
    sc_fetch_ahead();
    sc_TEXELS sc_texel;
    bool sc_reused = sc_look_up(sc_texel) == sc_hit;
    if (sc_reused) {
        sc_COMBINE();
    } else {
        sc_compute();
    }
    sc_shade();
    sc_STORE(sc_reused);
}
