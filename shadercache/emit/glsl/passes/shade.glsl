// Three passes, third: the colour, from the payload that stands in the cache of this frame.
uniform SAMPLER sc_payloads;  // what this frame stored so far
#if SC_TARGETS == 2
uniform SAMPLER sc_payloads_2;
#endif

PAYLOAD sc_payload;

void main() {
#ifdef CHANNELS
    sc_payload = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0).CHANNELS;
#else
    TEXEL texel = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0);
#if SC_TARGETS == 2
    TEXEL texel_2 = texelFetch(sc_payloads_2, ivec2(gl_FragCoord.xy), 0);
#endif
    sc_payload = UNPACKED;
#endif
    sc_shade();
}
