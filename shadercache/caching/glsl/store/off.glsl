// Whatever is computed is stored as it is.

sc_TEXEL sc_READ(sc_SAMPLERS cache, ivec2 place, uvec4 discrete) {
    return textureLod(cache, (vec2(place) + 0.5) / vec2(textureSize(cache, 0)), 0.0);
}

int sc_MISS_OF_ONE() {
    return sc_miss_depth;
}

int sc_NONE_FITS() {
    return sc_miss_depth;
}

void sc_GUARD() {
}

void sc_FIND_UNFIT() {
}
