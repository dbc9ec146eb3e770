// Not part of any variant: what the look-up says at every pixel that the shader does not discard.
out float sc_outcome;

void main() {
    SC_DECLARE_TEXELS;
    sc_outcome = float(sc_look_up(SC_TEXELS));
#if SC_WHOLE
    sc_shade();
#endif
}
