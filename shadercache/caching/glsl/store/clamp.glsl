// Values that the cache cannot hold are brought into its range: where they are stored, if it is one
// of half floats, and where they are read, since the third of three passes shows them as they were
// computed.

sc_TEXEL sc_READ(sc_SAMPLERS cache, ivec2 place, uvec4 discrete) {
    return sc_IN_RANGE(textureLod(cache, (vec2(place) + 0.5) / vec2(textureSize(cache, 0)), 0.0), discrete);
}

// Values as near as the range that is reused has them; nothing is near to NaN.
vec4 sc_near(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    bvec4 numbers = lessThanEqual(sizes, uvec4(0x7F800000u));
    vec4 held = mix(vec4(0.0), clamp(values, vec4(-sc_limit), vec4(sc_limit)), numbers);
    return mix(held, vec4(0.0), lessThan(sizes, uvec4(floatBitsToUint(sc_least))));
}

int sc_MISS_OF_ONE() {
    return sc_miss_depth;
}

int sc_NONE_FITS() {
    return sc_miss_depth;
}

void sc_GUARD() {
    sc_HOLD();
}

void sc_FIND_UNFIT() {
}
