// Payloads at a fraction of the rate, third: the colour, from the texels of this frame around the pixel;
// what none of them fits is left open. The shading takes derivatives, which are undefined behind a
// discard, so the discard comes last.
void main() {
    sc_TEXELS sc_texel;
    sc_lacks = !sc_neighbours(sc_texel);
    sc_COMBINE();
    sc_shade();
    if (sc_lacks) {
        discard;
    }
}
