// Three passes, first: carry the payload of hits over, leave misses open.
void main() {
    vec4 texel;
    if (sc_look_up(texel) != SC_HIT) {
        discard;
    }
    sc_payload = texel.CHANNELS;
    sc_store = sc_texel();
}
