// The four texels around the place. Where the place is the middle of a texel it has neighbours on
// either side: taken is the one that the texel's own sample does not lie towards.

void sc_FETCH(ivec2 last, vec2 place, out vec2 part, out ivec2 near,
        out sc_TEXELS a, out sc_TEXELS b, out sc_TEXELS c, out sc_TEXELS d, inout sc_TEXELS sc_texel) {
    vec2 whole = floor(place);
    part = place - whole;
    near = clamp(ivec2(whole), sc_FIRST(), last);
    a = sc_READ(sc_cache, near, sc_discrete);
    vec2 own = vec2(sc_OFFSET_X(a, a_2), sc_OFFSET_Y(a, a_2));
    bvec2 back = bvec2(part.x == 0.0 && own.x > 0.0, part.y == 0.0 && own.y > 0.0);
    ivec2 far = clamp(near + 1 - 2 * ivec2(back), sc_FIRST(), last);
    b = sc_READ(sc_cache, ivec2(far.x, near.y), sc_discrete);
    c = sc_READ(sc_cache, ivec2(near.x, far.y), sc_discrete);
    d = sc_READ(sc_cache, far, sc_discrete);
    sc_texel = a;
}
