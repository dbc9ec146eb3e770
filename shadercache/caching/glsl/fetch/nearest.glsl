// The texel nearest to the place.

void sc_FETCH(ivec2 last, vec2 place, out vec2 part, out ivec2 near,
        out sc_TEXELS a, out sc_TEXELS b, out sc_TEXELS c, out sc_TEXELS d, inout sc_TEXELS sc_texel) {
    vec2 whole = floor(place);
    part = place - whole;
    ivec2 low = clamp(ivec2(whole), sc_FIRST(), last);
    ivec2 high = min(low + ivec2(ceil(part)), last);
    near = ivec2(part.x < 0.5 ? low.x : high.x, part.y < 0.5 ? low.y : high.y);
    sc_texel = sc_READ(sc_cache, near, sc_discrete);
}
