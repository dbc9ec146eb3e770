// Two passes, first: shade whatever has its payload or does not need it; the rest is left open. The
// shading takes derivatives, which are undefined behind a discard, so the discard comes last.
void main() {
    SC_DECLARE_TEXELS;
    sc_reuse = sc_look_up(SC_TEXELS) == SC_HIT;
    SC_SET_VALID(sc_reuse);
    SC_UNPACK;
    sc_shade();
    SC_STORE_UNLESS(sc_reuse)
    if (sc_lacks) {
        discard;
    }
}
