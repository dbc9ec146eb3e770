// Shown is a plane through the four samples, fitted to where they truly lie; kept is the nearest one,
// and the integers and booleans of that.

int sc_RESAMPLE(ivec2 last, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d,
        vec4 fits, inout vec4 weights, bool agrees, inout bool marked, inout sc_TEXELS sc_texel) {
    a = sc_BARE(a);
    b = sc_BARE(b);
    c = sc_BARE(c);
    d = sc_BARE(d);
    sc_raw = away.x == least ? a : (away.y == least ? b : (away.z == least ? c : d));
    sc_offset = away.x == least ? vec2(right.x, up.x) : (away.y == least ? vec2(right.y, up.y) : (away.z == least ? vec2(right.z, up.z) : vec2(right.w, up.w)));
    weights = sc_plane(right, up, fits);
    // A sample right in the middle of its pixel is the value, to the bit.
    bool exact = sc_offset == vec2(0.0);
    sc_texel = sc_CLEAN(sc_MERGED(exact ? sc_raw : sc_OF_FLOATS(sc_fitted(sc_FLOATS(sc_raw), sc_FLOATS(a), sc_FLOATS(b), sc_FLOATS(c), sc_FLOATS(d), fits, weights)), sc_raw, sc_discrete));
}

// What each of four samples counts for a plane through them at the pixel's centre: least squares, the
// near ones heavier, and level where they lie in a line.
vec4 sc_plane(vec4 right, vec4 up, vec4 fits) {
    vec4 weights = fits * max(1.0 - abs(right), 0.02) * max(1.0 - abs(up), 0.02);
    weights /= dot(weights, vec4(1.0));
    vec2 middle = vec2(dot(weights, right), dot(weights, up));
    vec4 x = right - middle.x;
    vec4 y = up - middle.y;
    float xx = dot(weights, x * x) + 0.02;
    float yy = dot(weights, y * y) + 0.02;
    float xy = dot(weights, x * y);
    vec2 rise = vec2(yy * middle.x - xy * middle.y, xx * middle.y - xy * middle.x) / (xx * yy - xy * xy);
    return weights * (1.0 - x * rise.x - y * rise.y);
}

// Four samples by their weights, within their range. Those that do not fit may hold NaN, and 0 times
// NaN is NaN.
vec4 sc_fitted(vec4 raw, vec4 a, vec4 b, vec4 c, vec4 d, vec4 fits, vec4 weights) {
    vec4 first = fits.x > 0.0 ? a : raw;
    vec4 second = fits.y > 0.0 ? b : raw;
    vec4 third = fits.z > 0.0 ? c : raw;
    vec4 fourth = fits.w > 0.0 ? d : raw;
    vec4 least = min(min(first, second), min(third, fourth));
    vec4 most = max(max(first, second), max(third, fourth));
    return clamp(weights.x * first + weights.y * second + weights.z * third + weights.w * fourth, least, most);
}
