// Has the surface become much larger?

int sc_TEST(ivec2 last, vec2 place, vec4 jacobian, vec2 slope, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d, sc_TEXELS sc_texel,
        out vec4 fits, out vec4 weights, out bool agrees, out bool marked) {
    // The area in the previous frame that a pixel shows.
    if (!(abs(jacobian.x * jacobian.w - jacobian.y * jacobian.z) * sc_magnification * sc_magnification >= 1.0)) {
        return sc_miss_magnified;
    }
}
