// The pixel's turn to be refreshed.

int sc_TEST(ivec2 last, vec2 place, vec4 jacobian, vec2 slope, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d, sc_TEXELS sc_texel,
        out vec4 fits, out vec4 weights, out bool agrees, out bool marked) {
    if (sc_due()) {
        return sc_refresh;
    }
}
