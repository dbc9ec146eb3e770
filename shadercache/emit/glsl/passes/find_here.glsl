// Parked misses, first, where not every fragment needs the payload: shade whatever has its payload or
// does not need it; of the rest keep what the shader needs.
void main() {
    sc_fetch_ahead();
    sc_TEXELS sc_texel;
    sc_reuse = sc_look_up(sc_texel) == sc_hit;
    sc_park();
    sc_SET_VALID(sc_reuse);
    sc_COMBINE();
    sc_shade();
    sc_STORE(sc_reuse);
    if (sc_lacks) {
        sc_store = sc_MISSED();
    }
}
