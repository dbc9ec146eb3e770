// Not part of any variant: what the look-up says at every visible pixel.
out float sc_outcome;

void main() {
    SC_DECLARE_TEXELS;
    sc_outcome = float(sc_look_up(SC_TEXELS));
}
