// Texels of unsigned integers, for payloads with integers or booleans: floats lie there by their
// bits. sc_discrete marks the channels that hold none.

vec4 sc_FLOATS(uvec4 texel) {
    return uintBitsToFloat(texel);
}

uvec4 sc_OF_FLOATS(vec4 floats) {
    return floatBitsToUint(floats);
}

uvec4 sc_MERGED(uvec4 floats, uvec4 texel, uvec4 discrete) {
    return (texel & discrete) | (floats & ~discrete);
}

uvec4 sc_ONLY_FLOATS(uvec4 texel, uvec4 discrete) {
    return texel & ~discrete;
}

uvec4 sc_BLENDED(uvec4 a, uvec4 b, uvec4 c, uvec4 d, vec2 part, uvec4 discrete) {
    return sc_blend(a, b, c, d, part, discrete);
}

uint sc_MARKED(float depth) {
    return floatBitsToUint(depth) | (sc_moved ? 0x80000000u : 0u);
}

uvec4 sc_IN_RANGE(uvec4 texel, uvec4 discrete) {
    return sc_in_range(texel, discrete);
}

void sc_HOLD() {
}

void sc_AGREE() {
    if (sc_IF_INTEGERS(!sc_same(a, b, c, d, sc_discrete))) {
        return false;
    }
}

uvec4 sc_MISSED() {
    return uvec4(uint(sc_group), 0u, 0u, sc_missed_depth);
}

// What four texels hold at a place between them: floats are blended, integers and booleans are those
// of one of the texels.
uvec4 sc_blend(uvec4 a, uvec4 b, uvec4 c, uvec4 d, vec2 part, uvec4 discrete) {
    vec4 low = mix(uintBitsToFloat(a), uintBitsToFloat(b), part.x);
    vec4 high = mix(uintBitsToFloat(c), uintBitsToFloat(d), part.x);
    vec4 blended = mix(low, high, part.y);
    return (a & discrete) | (floatBitsToUint(blended) & ~discrete);
}

// Floats as near as the range that is reused has them; the rest as it is.
uvec4 sc_in_range(uvec4 texel, uvec4 discrete) {
    return (texel & discrete) | (floatBitsToUint(sc_near(uintBitsToFloat(texel))) & ~discrete);
}

// Do four texels hold the same integers and booleans?
bool sc_same(uvec4 a, uvec4 b, uvec4 c, uvec4 d, uvec4 discrete) {
    return (((a ^ b) | (a ^ c) | (a ^ d)) & discrete) == uvec4(0u);
}
