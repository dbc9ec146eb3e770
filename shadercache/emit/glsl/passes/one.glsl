// One pass: reuse the payload or compute it, then shade.
void main() {
    sc_fetch_ahead();
    vec4 texel;
    if (sc_look_up(texel) == SC_HIT) {
        sc_payload = texel.CHANNELS;
    } else {
        sc_compute();
    }
    sc_shade();
    sc_store = sc_texel();
}
