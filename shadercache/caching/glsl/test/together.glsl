// The four texels together: do all of them show the surface?

int sc_TEST(ivec2 last, vec2 place, vec4 jacobian, vec2 slope, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d, sc_TEXELS sc_texel,
        out vec4 fits, out vec4 weights, out bool agrees, out bool marked) {
    // The blended depth must agree closely, each single one roughly: else a front and a back could
    // blend to just the right depth. A comparison with NaN is false and so a miss.
    vec4 each = abs(sc_OFF(sc_DEPTHS(a, b, c, d)));
    if (!(abs(sc_OFF(sc_FLOATS(sc_texel.w))) <= sc_TOLERANCE() && all(lessThanEqual(each, vec4(sc_ROUGHLY()))))) {
        return sc_NONE_FITS();
    }
    sc_TEST_OBJECT_OF_FOUR();
}

bool sc_IF_AGREES(bool moves) {
    return moves;
}
