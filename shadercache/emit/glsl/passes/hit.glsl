// Two passes, first: shade hits from the payload, leave misses open.
void main() {
    SC_DECLARE_TEXELS;
    if (sc_look_up(SC_TEXELS) != SC_HIT) {
        discard;
    }
    SC_UNPACK;
    sc_shade();
    SC_STORE_AGAIN;
}
