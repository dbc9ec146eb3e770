// Not part of any variant: the payload alone, drawn like the original, to measure what it costs.
out vec4 sc_value;

SC_DECLARE_PAYLOADS;

void main() {
#if SC_WHOLE
    sc_shade();
#else
    sc_compute();
#endif
#if SC_BITS
    sc_value = vec4(uvec4(SC_PACKED_1, 1u));
#else
    sc_value = vec4(SC_PACKED_1, 1.0);
#endif
#if SC_TARGETS == 2
    sc_value += vec4(SC_TEXEL(SC_PACKED_2));
#endif
}
