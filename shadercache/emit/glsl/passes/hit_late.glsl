// Two passes, first: shade hits from the payload, leave misses open. The shading takes derivatives,
// which are undefined behind a discard, so the discard comes last.
void main() {
    SC_DECLARE_TEXELS;
    sc_lacks = sc_look_up(SC_TEXELS) != SC_HIT;
    SC_UNPACK;
    sc_shade();
    SC_STORE_AGAIN;
    if (sc_lacks) {
        discard;
    }
}
