out float sc_outcome;

// Not part of any variant: has the pixel its payloads (1), does the shader do without them (2), or
// are there some that a guard keeps from being reused (3)?
void main() {
    sc_COMPUTE();
    sc_NEED();
    sc_FIND_UNFIT();
}
