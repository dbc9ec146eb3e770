// Not part of any variant: the payload alone, drawn like the original, to measure what it costs.
out vec4 sc_value;

PAYLOAD sc_payload;

void main() {
    sc_compute();
#if SC_BITS
    sc_value = vec4(uvec4(PACKED_1, 1u));
#else
    sc_value = vec4(PACKED_1, 1.0);
#endif
#if SC_TARGETS == 2
    sc_value += vec4(TEXEL(PACKED_2));
#endif
}
