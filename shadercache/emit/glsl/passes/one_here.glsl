// One pass: take the payload from the cache or compute it where it is needed, if it is.
void main() {
    vec4 texel;
    sc_reuse = sc_look_up(texel) == SC_HIT;
    sc_valid = sc_reuse;
    sc_payload = texel.CHANNELS;
    sc_shade();
    sc_store = sc_texel();
}
