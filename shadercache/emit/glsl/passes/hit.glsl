// Two passes, first: shade hits from the payload, leave misses open.
void main() {
    vec4 texel;
    if (sc_look_up(texel) != SC_HIT) {
        discard;
    }
    sc_payload = texel.CHANNELS;
    sc_shade();
    sc_store = sc_texel();
}
