// Cached depths are what they are.

vec4 sc_DEPTHS(sc_TEXEL a, sc_TEXEL b, sc_TEXEL c, sc_TEXEL d) {
    return vec4(sc_FLOATS(a.w), sc_FLOATS(b.w), sc_FLOATS(c.w), sc_FLOATS(d.w));
}
