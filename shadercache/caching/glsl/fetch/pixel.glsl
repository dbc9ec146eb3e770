// The pixel's own texel.

void sc_FETCH(ivec2 last, vec2 place, out vec2 part, out ivec2 near,
        out sc_TEXELS a, out sc_TEXELS b, out sc_TEXELS c, out sc_TEXELS d, inout sc_TEXELS sc_texel) {
    near = sc_OWN_TEXEL();
    sc_texel = sc_READ(sc_cache, near, sc_discrete);
}
