// Parked misses, first: shade hits from the payload; of misses keep what the rest of the shader needs.
void main() {
    sc_fetch_ahead();
    sc_TEXELS sc_texel;
    sc_lacks = sc_look_up(sc_texel) != sc_hit;
    sc_park();
    sc_COMBINE();
    sc_shade();
    sc_STORE_REUSED();
    if (sc_lacks) {
        sc_store = sc_MISSED();
    }
}
