// No integer lies between two others: where the texels differ, none of them is right.

int sc_RESAMPLE(ivec2 last, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d,
        vec4 fits, inout vec4 weights, bool agrees, inout bool marked, inout sc_TEXELS sc_texel) {
    if (sc_IF_INTEGERS(!sc_same(a, b, c, d, sc_discrete))) {
        return sc_miss_depth;
    }
}

// Do four texels hold the same integers and booleans?
bool sc_same(uvec4 a, uvec4 b, uvec4 c, uvec4 d, uvec4 discrete) {
    return (((a ^ b) | (a ^ c) | (a ^ d)) & discrete) == uvec4(0u);
}
