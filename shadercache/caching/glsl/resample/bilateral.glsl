// Bilateral: along edges what fits of the four, as if the rest were not there.

int sc_RESAMPLE(ivec2 last, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d,
        vec4 fits, inout vec4 weights, bool agrees, inout bool marked, inout sc_TEXELS sc_texel) {
    if (!agrees) {
        weights *= fits;
        float total = dot(weights, vec4(1.0));
        if (!(total >= sc_LEAST_WEIGHT)) {
            return sc_NO_FIT();
        }
        weights /= total;
        sc_texel = sc_MERGED(sc_OF_FLOATS(sc_chosen(sc_FLOATS(a), sc_FLOATS(b), sc_FLOATS(c), sc_FLOATS(d), weights)), a, sc_discrete);
        marked = true;
    }
}

// Four texels by their weights, those without one left out: they may hold NaN, and 0 times NaN is
// NaN.
vec4 sc_chosen(vec4 a, vec4 b, vec4 c, vec4 d, vec4 weights) {
    vec4 sum = weights.x > 0.0 ? weights.x * a : vec4(0.0);
    sum += weights.y > 0.0 ? weights.y * b : vec4(0.0);
    sum += weights.z > 0.0 ? weights.z * c : vec4(0.0);
    return sum + (weights.w > 0.0 ? weights.w * d : vec4(0.0));
}
