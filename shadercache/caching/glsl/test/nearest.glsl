// The nearest texel: was the surface seen there?

int sc_TEST(ivec2 last, vec2 place, vec4 jacobian, vec2 slope, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d, sc_TEXELS sc_texel,
        out vec4 fits, out vec4 weights, out bool agrees, out bool marked) {
    // The texel lies beside the place; so does what its depth should be. A comparison with NaN is
    // false and so a miss.
    vec2 aside = vec2(near) - place;
    if (!(abs(sc_OFF(sc_FLOATS(sc_texel.w)) - dot(slope, aside)) <= sc_TOLERANCE())) {
        return sc_MISS_OF_ONE();
    }
    sc_TEST_OBJECT_OF_ONE();
}
