// Two passes, first: shade hits from the payload, leave misses open. The shading takes derivatives,
// which are undefined behind a discard, so the discard comes last.
void main() {
    DECLARE_TEXELS;
    int outcome = sc_look_up(TEXELS);
    sc_payload = UNPACKED;
    sc_shade();
    STORE;
    if (outcome != SC_HIT) {
        discard;
    }
}
