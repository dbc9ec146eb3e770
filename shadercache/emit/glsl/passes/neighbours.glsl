// Payloads at a fraction of the rate, third: the colour, from the texels of this frame around the pixel;
// what none of them fits is left open.
void main() {
    sc_TEXELS sc_texel;
    if (!sc_neighbours(sc_texel)) {
        discard;
    }
    sc_COMBINE();
    sc_shade();
}
