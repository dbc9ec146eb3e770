// Not part of any variant: has the pixel its payloads (1), does the shader do without them (2), or
// are there some that a guard keeps from being reused (3)?
out float sc_outcome;

void main() {
#if SC_WHOLE
    sc_shade();
    sc_outcome = SC_VALID ? 1.0 : 2.0;
#else
    sc_compute();
    sc_outcome = 1.0;
#endif
#if SC_GUARD_MISS
    SC_TEXEL texel = SC_TEXEL(SC_PACKED_1, 0);
    bool unfit = sc_unfit(SC_FLOATS(SC_ONLY_FLOATS(texel, SC_DISCRETE_1)));
#if SC_TARGETS == 2
    SC_TEXEL texel_2 = SC_TEXEL(SC_PACKED_2);
    unfit = unfit || sc_unfit(SC_FLOATS(SC_ONLY_FLOATS(texel_2, SC_DISCRETE_2)));
#endif
    if (sc_outcome == 1.0 && unfit) {
        sc_outcome = 3.0;
    }
#endif
}
