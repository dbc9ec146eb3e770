out float sc_outcome;

// Not part of any variant: what the look-up says at every pixel that the shader does not discard.
void main() {
    sc_TEXELS sc_texel;
    sc_outcome = float(sc_look_up(sc_texel));
    sc_PASS_THROUGH();
}
