// Two passes, first: shade whatever has its payload or does not need it; the rest is left open. The
// shading takes derivatives, which are undefined behind a discard, so the discard comes last.
void main() {
    DECLARE_TEXELS;
    sc_reuse = sc_look_up(TEXELS) == SC_HIT;
    sc_valid = sc_reuse;
    sc_payload = UNPACKED;
    sc_shade();
    STORE;
    if (sc_lacks) {
        discard;
    }
}
