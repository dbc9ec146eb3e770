// Three passes, third: the colour, from the payload that stands in the cache of this frame.
uniform sampler2D sc_payloads;  // what this frame stored so far

PAYLOAD sc_payload;

void main() {
    sc_payload = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0).CHANNELS;
    sc_shade();
}
