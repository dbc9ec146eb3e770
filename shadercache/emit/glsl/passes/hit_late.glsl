// Two passes, first: shade hits from the payload, leave misses open. The shading takes derivatives,
// which are undefined behind a discard, so the discard comes last.
void main() {
    vec4 texel;
    int outcome = sc_look_up(texel);
    sc_payload = texel.CHANNELS;
    sc_shade();
    sc_store = sc_texel();
    if (outcome != SC_HIT) {
        discard;
    }
}
