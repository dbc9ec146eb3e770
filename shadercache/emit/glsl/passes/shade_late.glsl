// Three passes, third: the colour, from the payload that stands in the cache of this frame. The
// shading takes derivatives, which are undefined behind a discard, so the discard comes last.
uniform SC_SAMPLER sc_payloads;  // what this frame stored so far
#if SC_TARGETS == 2
uniform SC_SAMPLER sc_payloads_2;
#endif

SC_DECLARE_PAYLOADS;

void main() {
    SC_TEXEL SC_LOCAL_1 = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0);
#if SC_TARGETS == 2
    SC_TEXEL SC_LOCAL_2 = texelFetch(sc_payloads_2, ivec2(gl_FragCoord.xy), 0);
#endif
    SC_UNPACK;
    sc_shade();
    // The second pass has drawn the colour here, and the payload was no good.
    if (SC_LOCAL_1.w == SC_POISON_DEPTH) {
        discard;
    }
}
