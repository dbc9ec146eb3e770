// Sixteen texels, where all of them show the surface; else the four will do. The filter says what
// sc_kernel is.

int sc_RESAMPLE(ivec2 last, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d,
        vec4 fits, inout vec4 weights, bool agrees, inout bool marked, inout sc_TEXELS sc_texel) {
    if (sc_IF_AGREES(part != vec2(0.0))) {
        ivec4 columns = clamp(near.x + ivec4(-1, 0, 1, 2), ivec4(sc_FIRST_COLUMN()), ivec4(last.x));
        ivec4 lines = clamp(near.y + ivec4(-1, 0, 1, 2), ivec4(sc_FIRST_ROW()), ivec4(last.y));
        vec4 across = sc_kernel(part.x);
        vec4 up = sc_kernel(part.y);
        sc_SUMS sum = vec4(0.0);
        vec4 first = sc_row(columns, lines.x, up.x * across, sum);
        vec4 second = sc_row(columns, lines.y, up.y * across, sum);
        vec4 third = sc_row(columns, lines.z, up.z * across, sum);
        vec4 fourth = sc_row(columns, lines.w, up.w * across, sum);
        vec4 least = min(min(first, second), min(third, fourth));
        vec4 most = max(max(first, second), max(third, fourth));
        if (sc_IF_OWN(all(lessThanEqual(abs(sc_OFF(least)), vec4(sc_ROUGHLY()))) && all(lessThanEqual(abs(sc_OFF(most)), vec4(sc_ROUGHLY()))))) {
            sum.w = sc_FLOATS(sc_texel.w);
            sc_texel = sc_MERGED(sc_within(a, b, c, d, sum), sc_texel, sc_discrete);
        }
    }
}

// Adds the four texels of a row to a sum, and gives their depths.
vec4 sc_row(ivec4 columns, int row, vec4 weights, inout sc_SUMS sum) {
    sc_TEXELS a = sc_READ(sc_cache, ivec2(columns.x, row), sc_discrete);
    sc_TEXELS b = sc_READ(sc_cache, ivec2(columns.y, row), sc_discrete);
    sc_TEXELS c = sc_READ(sc_cache, ivec2(columns.z, row), sc_discrete);
    sc_TEXELS d = sc_READ(sc_cache, ivec2(columns.w, row), sc_discrete);
    sum += sc_weighted(sc_FLOATS(a), sc_FLOATS(b), sc_FLOATS(c), sc_FLOATS(d), weights);
    sc_NOTE_OBJECT();
    return sc_DEPTHS(a, b, c, d);
}

// Four texels by their weights.
vec4 sc_weighted(vec4 a, vec4 b, vec4 c, vec4 d, vec4 weights) {
    return weights.x * a + weights.y * b + weights.z * c + weights.w * d;
}

// A filtered texel within the range of the four: what a sharp filter adds to waves it would add
// again in each frame, and in the end nothing else would be left.
sc_TEXEL sc_within(sc_TEXEL a, sc_TEXEL b, sc_TEXEL c, sc_TEXEL d, vec4 sum) {
    vec4 least = min(min(sc_FLOATS(a), sc_FLOATS(b)), min(sc_FLOATS(c), sc_FLOATS(d)));
    vec4 most = max(max(sc_FLOATS(a), sc_FLOATS(b)), max(sc_FLOATS(c), sc_FLOATS(d)));
    return sc_OF_FLOATS(clamp(sum, least, most));
}
