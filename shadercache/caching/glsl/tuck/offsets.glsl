// An offset lies in the 12 lowest bits of each of the first two channels, in 2000ths of a pixel. Of the
// payload 20 bits are left there: it is rounded by no more than a half float is.

sc_TEXEL sc_BARE(sc_TEXEL texel) {
    return sc_bare(texel);
}

sc_TEXEL sc_CLEAN(sc_TEXEL texel) {
    return sc_clean(texel);
}

float sc_OFFSET_IN(float channel) {
    return float(int(floatBitsToUint(channel) & 0xFFFu) - 2048) / 2000.0;
}

// A driver may flush what is below the smallest normal number, with all that lies in it: that number
// stands for zero.
vec4 sc_tucked(vec4 texel) {
    uvec2 bits = floatBitsToUint(texel.xy);
    // NaN becomes infinity, which rounding does not make a number of.
    uvec2 sizes = min(bits & 0x7FFFFFFFu, uvec2(0x7F800000u)) + 0x800u;
    sizes = max(sizes & 0x7FFFF000u, uvec2(0x00800000u));
    uvec2 code = uvec2(sc_offset * 2000.0 + 2048.5);
    return vec4(uintBitsToFloat((bits & 0x80000000u) | sizes | code), texel.zw);
}

// The payload without the offset.
vec4 sc_bare(vec4 texel) {
    return vec4(uintBitsToFloat(floatBitsToUint(texel.xy) & 0xFFFFF000u), texel.zw);
}

// A payload that may be shown: what stands for zero is zero.
vec4 sc_clean(vec4 texel) {
    return vec4(mix(texel.xy, vec2(0.0), lessThan(abs(texel.xy), vec2(2.4e-38))), texel.zw);
}
