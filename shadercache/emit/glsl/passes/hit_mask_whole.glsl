// Not part of any variant: what the look-up says at every pixel that the shader does not discard.
out float sc_outcome;

void main() {
    vec4 texel;
    sc_outcome = float(sc_look_up(texel));
    sc_shade();
}
