// Not part of any variant: the payload alone, drawn like the original, to measure what it costs.
out vec4 sc_value;

PAYLOAD sc_payload;

void main() {
    sc_shade();
    sc_value = vec4(sc_payload PADDING, 1.0);
}
