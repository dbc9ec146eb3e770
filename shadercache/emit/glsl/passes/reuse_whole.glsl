// Three passes, first: carry the payload of hits over, leave misses open; and discard what the shader
// discards.
void main() {
    vec4 texel;
    if (sc_look_up(texel) != SC_HIT) {
        discard;
    }
    sc_valid = true;
    sc_payload = texel.CHANNELS;
    sc_shade();
    sc_store = sc_texel();
}
