// The four texels around the place, and what they blend to.

void sc_FETCH(ivec2 last, vec2 place, out vec2 part, out ivec2 near,
        out sc_TEXELS a, out sc_TEXELS b, out sc_TEXELS c, out sc_TEXELS d, inout sc_TEXELS sc_texel) {
    // At rest the motion is exactly zero: all four are the pixel's own texel, nothing is filtered.
    vec2 whole = floor(place);
    part = place - whole;
    near = clamp(ivec2(whole), sc_FIRST(), last);
    ivec2 far = min(near + ivec2(ceil(part)), last);
    a = sc_READ(sc_cache, near, sc_discrete);
    b = sc_READ(sc_cache, ivec2(far.x, near.y), sc_discrete);
    c = sc_READ(sc_cache, ivec2(near.x, far.y), sc_discrete);
    d = sc_READ(sc_cache, far, sc_discrete);
    sc_texel = sc_BLENDED(a, b, c, d, part, sc_discrete);
}
