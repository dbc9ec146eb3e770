// An offset lies in the 12 lowest bits of each of the first two channels, in 2000ths of a pixel, and the
// object's number in those of the third. Of the payload 20 bits are left there: it is rounded by no more
// than a half float is.

sc_TEXEL sc_BARE(sc_TEXEL texel) {
    return sc_bare(texel);
}

sc_TEXEL sc_CLEAN(sc_TEXEL texel) {
    return sc_clean(texel);
}

float sc_OFFSET_IN(float channel) {
    return float(int(floatBitsToUint(channel) & 0xFFFu) - 2048) / 2000.0;
}

int sc_NUMBER_IN(float channel) {
    return int(floatBitsToUint(channel) & 0xFFFu);
}

// A driver may flush what is below the smallest normal number, with all that lies in it: that number
// stands for zero.
vec4 sc_tucked(vec4 texel) {
    uvec3 bits = floatBitsToUint(texel.xyz);
    // NaN becomes infinity, which rounding does not make a number of.
    uvec3 sizes = min(bits & 0x7FFFFFFFu, uvec3(0x7F800000u)) + 0x800u;
    sizes = max(sizes & 0x7FFFF000u, uvec3(0x00800000u));
    uvec3 code = uvec3(uvec2(sc_offset * 2000.0 + 2048.5), uint(sc_object));
    return vec4(uintBitsToFloat((bits & 0x80000000u) | sizes | code), texel.w);
}

// The payload alone.
vec4 sc_bare(vec4 texel) {
    return vec4(uintBitsToFloat(floatBitsToUint(texel.xyz) & 0xFFFFF000u), texel.w);
}

// A payload that may be shown: what stands for zero is zero.
vec4 sc_clean(vec4 texel) {
    return vec4(mix(texel.xyz, vec3(0.0), lessThan(abs(texel.xyz), vec3(2.4e-38))), texel.w);
}
