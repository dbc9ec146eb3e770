// The pixel's own texel: is the surface as far away as it was there?

int sc_TEST(ivec2 last, vec2 place, vec4 jacobian, vec2 slope, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d, sc_TEXELS sc_texel,
        out vec4 fits, out vec4 weights, out bool agrees, out bool marked) {
    // A comparison with NaN is false and so a miss.
    if (!(abs(sc_FLOATS(sc_texel.w) - sc_DEPTH()) <= sc_TOLERANCE() * sc_UNIT())) {
        return sc_MISS_OF_ONE();
    }
    sc_TEST_OBJECT_OF_ONE();
}
