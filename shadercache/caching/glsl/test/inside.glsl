// Was the place in the picture?

int sc_TEST(ivec2 last, vec2 place, vec4 jacobian, vec2 slope, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d, sc_TEXELS sc_texel,
        out vec4 fits, out vec4 weights, out bool agrees, out bool marked) {
    // All four texels lie in the cache; a point behind the camera was not seen.
    if (!(sc_previous.w > 0.0 && all(greaterThanEqual(place, sc_LOWEST())) && all(lessThanEqual(place, vec2(last))))) {
        return sc_miss_outside;
    }
}
