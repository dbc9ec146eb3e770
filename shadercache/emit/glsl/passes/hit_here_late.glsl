// Two passes, first: shade whatever has its payload or does not need it; the rest is left open. The
// shading takes derivatives, which are undefined behind a discard, so the discard comes last.
void main() {
    vec4 texel;
    sc_reuse = sc_look_up(texel) == SC_HIT;
    sc_valid = sc_reuse;
    sc_payload = texel.CHANNELS;
    sc_shade();
    sc_store = sc_texel();
    if (sc_lacks) {
        discard;
    }
}
