out vec4 sc_value;

// Not part of any variant: the payload alone, drawn like the original, to measure what it costs.
void main() {
    sc_COMPUTE();
    sc_VALUE();
}
