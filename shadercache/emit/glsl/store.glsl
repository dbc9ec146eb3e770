// What a pass writes into the cache: the payload, padded to three channels, and 1/w.

in vec4 sc_current;  // clip-space position in this frame
out vec4 sc_store;   // the texel of the cache

PAYLOAD sc_payload;

vec4 sc_texel() {
    return vec4(sc_payload PADDING, 1.0 / sc_current.w);
}
