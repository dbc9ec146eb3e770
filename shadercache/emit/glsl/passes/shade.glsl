// Three passes, third: the colour, from the payload that stands in the cache of this frame.
uniform SC_SAMPLER sc_payloads;  // what this frame stored so far
#if SC_TARGETS == 2
uniform SC_SAMPLER sc_payloads_2;
#endif

SC_DECLARE_PAYLOADS;

void main() {
#ifdef SC_CHANNELS
    sc_payload = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0).SC_CHANNELS;
#else
    SC_TEXEL SC_LOCAL_1 = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0);
#if SC_TARGETS == 2
    SC_TEXEL SC_LOCAL_2 = texelFetch(sc_payloads_2, ivec2(gl_FragCoord.xy), 0);
#endif
    SC_UNPACK;
#endif
    sc_shade();
}
