// Where not every fragment needs the payload: one pass, which computes it where it stands, or the first
// of two, which shades whatever has its payload or does not need it and leaves the rest open.
void main() {
    SC_DECLARE_TEXELS;
    sc_reuse = sc_look_up(SC_TEXELS) == SC_HIT;
    SC_SET_VALID(sc_reuse);
    SC_UNPACK;
    sc_shade();
    SC_STORE_UNLESS(sc_reuse)
}
