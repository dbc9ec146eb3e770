// Values that are not finite, or that the cache cannot hold, are stored with a depth that matches
// nothing: the next frame computes them anew.

sc_TEXEL sc_READ(sc_SAMPLERS cache, ivec2 place, uvec4 discrete) {
    return textureLod(cache, (vec2(place) + 0.5) / vec2(textureSize(cache, 0)), 0.0);
}

int sc_MISS_OF_ONE() {
    return sc_texel.w == sc_poison_depth ? sc_miss_poison : sc_miss_depth;
}

int sc_NONE_FITS() {
    return a.w == sc_poison_depth || b.w == sc_poison_depth || c.w == sc_poison_depth || d.w == sc_poison_depth ? sc_miss_poison : sc_miss_depth;
}

// Can the cache not hold a value? The bits are compared: they are in the order of the sizes, NaN lies
// above infinity, and no driver can make less of them than they are.
bool sc_unfit(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    return any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit)))) || any(lessThan(sizes - 1u, uvec4(least)));
}

// Marks a texel that must not be reused. The third of three passes reads it in this frame, so it
// holds what was computed, or what comes nearest of larger numbers.
void sc_guard() {
    bool unfit = sc_ANY_FLOATS(sc_unfit(sc_FLOATS(sc_ONLY_FLOATS(sc_store, sc_discrete))));
    if (unfit) {
        sc_HOLD();
        sc_store.w = sc_poison_depth;
    }
}

void sc_GUARD() {
    sc_guard();
}

void sc_FIND_UNFIT() {
    sc_TEXELS texel = sc_PACKED();
    bool unfit = sc_ANY_FLOATS(sc_unfit(sc_FLOATS(sc_ONLY_FLOATS(texel, sc_discrete))));
    if (sc_outcome == 1.0 && unfit) {
        sc_outcome = 3.0;
    }
}
