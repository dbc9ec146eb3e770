// The four texels, together and one by one, and where their samples lie: one at least must show the
// surface and have its sample near the pixel. A sample's own place is known, so it can be taken alone
// as often as may be.

int sc_TEST(ivec2 last, vec2 place, vec4 jacobian, vec2 slope, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d, sc_TEXELS sc_texel,
        out vec4 fits, out vec4 weights, out bool agrees, out bool marked) {
    vec2 low = vec2(near) - place;
    vec2 high = vec2(far) - place;
    vec4 x = vec4(low.x, high.x, low.x, high.x);
    vec4 y = vec4(low.y, low.y, high.y, high.y);
    vec4 depths = sc_DEPTHS(a, b, c, d);
    // Which texels fit by themselves, where the surface slopes on as it does at the pixel?
    fits = vec4(lessThanEqual(abs(sc_OFF(depths) - slope.x * x - slope.y * y), vec4(sc_TOLERANCE())));
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
    // The flatter the surface, the surer is where samples beside the pixel have gone.
    float reach = fits == vec4(1.0) ? sc_REACH : (agrees ? sc_REACH_ROUGH : sc_REACH_ALONE);
    fits = agrees ? vec4(1.0) : fits;
    // Where the samples lie from the pixel, in pixels of this frame: depths are of the texels'
    // middles, samples lie beside them.
    x += vec4(sc_OFFSET_X(a, a_2), sc_OFFSET_X(b, b_2), sc_OFFSET_X(c, c_2), sc_OFFSET_X(d, d_2));
    y += vec4(sc_OFFSET_Y(a, a_2), sc_OFFSET_Y(b, b_2), sc_OFFSET_Y(c, c_2), sc_OFFSET_Y(d, d_2));
    float area = jacobian.x * jacobian.w - jacobian.y * jacobian.z;
    vec4 right = (jacobian.w * x - jacobian.z * y) / area;
    vec4 up = (jacobian.x * y - jacobian.y * x) / area;
    vec4 away = max(abs(right), abs(up));
    away = mix(vec4(1e9), away, greaterThan(fits, vec4(0.0)));
    float least = min(min(away.x, away.y), min(away.z, away.w));
    // What has become so much larger was seen too obliquely to tell where its samples lie.
    if (!(least <= reach && area >= sc_LEAST_AREA)) {
        return sc_NO_FIT();
    }
}
