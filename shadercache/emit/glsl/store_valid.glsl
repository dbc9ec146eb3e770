// What a pass writes into the cache where not every fragment has a payload: as in store.glsl, or an
// empty texel, which matches nothing.

in vec4 sc_current;  // clip-space position in this frame
out vec4 sc_store;   // the texel of the cache

PAYLOAD sc_payload;
bool sc_reuse = false;  // is there a payload from the cache?
bool sc_valid = false;  // is there a payload to store?
bool sc_lacks = false;  // was a payload needed, and none there?

vec4 sc_texel() {
    if (!sc_valid) {
        return vec4(0.0, 0.0, 0.0, -1.0);
    }
    return vec4(sc_payload PADDING, 1.0 / sc_current.w);
}
