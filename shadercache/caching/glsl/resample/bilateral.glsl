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
