// Not part of any variant: has the pixel its payloads (1), or does the shader do without them (2)?
out float sc_outcome;

void main() {
    sc_shade();
    sc_outcome = SC_VALID ? 1.0 : 2.0;
}
