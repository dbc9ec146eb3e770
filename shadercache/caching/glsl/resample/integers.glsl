// No integer lies between two others: where the texels differ, none of them is right.

int sc_RESAMPLE(ivec2 last, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d,
        vec4 fits, inout vec4 weights, bool agrees, inout bool marked, inout sc_TEXELS sc_texel) {
    if (sc_IF_INTEGERS(!sc_same(a, b, c, d, sc_discrete))) {
        return sc_miss_depth;
    }
}
