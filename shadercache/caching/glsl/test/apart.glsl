// The four texels, together and one by one: along an edge those that show the surface are taken
// without the others, and what is made of them is marked by a negative depth.

int sc_TEST(ivec2 last, vec2 place, vec4 jacobian, vec2 slope, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d, sc_TEXELS sc_texel,
        out vec4 fits, out vec4 weights, out bool agrees, out bool marked) {
    vec4 kept = vec4(sc_FLOATS(a.w), sc_FLOATS(b.w), sc_FLOATS(c.w), sc_FLOATS(d.w));
    vec4 depths = abs(kept);
    bvec4 moved = lessThan(kept, vec4(0.0));
    // Which texels fit by themselves, where the surface slopes on as it does at the pixel?
    vec4 aside = sc_OFF(depths) - slope.x * vec4(-part.x, 1.0 - part.x, -part.x, 1.0 - part.x)
        - slope.y * vec4(-part.y, -part.y, 1.0 - part.y, 1.0 - part.y);
    fits = vec4(lessThanEqual(abs(aside), vec4(sc_TOLERANCE()))) * vec4(not(moved));
    sc_FIT_OBJECT(fits);
    // Do all four together show one surface, and is it the pixel's?
    weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.y, 1.0 - part.y, part.y, part.y);
    float blended = dot(weights, depths);
    sc_ONE_SURFACE(lessThanEqual(abs(sc_OFF(depths)), vec4(sc_ROUGHLY())));
    agrees = one_surface && abs(sc_OFF(blended)) <= sc_TOLERANCE();
    // A fold: one of its sides must not be taken for the other.
    if (one_surface && !agrees) {
        return sc_miss_depth;
    }
    marked = dot(weights, vec4(moved)) > 0.0;
}

bool sc_IF_AGREES(bool moves) {
    return moves && agrees;
}
