// How texels are put together. Words in capitals: see macros.glsl and depth.glsl.

#if SC_BITS
// What four texels hold at a place between them: floats are blended, integers and booleans (marked
// in a mask) are those of one of the texels.
uvec4 sc_blend(uvec4 a, uvec4 b, uvec4 c, uvec4 d, vec2 part, uvec4 discrete) {
    vec4 low = mix(uintBitsToFloat(a), uintBitsToFloat(b), part.x);
    vec4 high = mix(uintBitsToFloat(c), uintBitsToFloat(d), part.x);
    vec4 blended = mix(low, high, part.y);
    return (a & discrete) | (floatBitsToUint(blended) & ~discrete);
}

// Do four texels hold the same integers and booleans?
bool sc_same(uvec4 a, uvec4 b, uvec4 c, uvec4 d, uvec4 discrete) {
    return (((a ^ b) | (a ^ c) | (a ^ d)) & discrete) == uvec4(0u);
}
#endif

#if SC_GUARD_CLAMP
uniform float sc_limit;  // the largest value that is reused
uniform float sc_least;  // the smallest one above zero that it surely holds

// Values as near as the range that is reused has them; nothing is near to NaN.
vec4 sc_near(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    bvec4 numbers = lessThanEqual(sizes, uvec4(0x7F800000u));
    vec4 held = mix(vec4(0.0), clamp(values, vec4(-sc_limit), vec4(sc_limit)), numbers);
    return mix(held, vec4(0.0), lessThan(sizes, uvec4(floatBitsToUint(sc_least))));
}

#if SC_BITS
uvec4 sc_in_range(uvec4 texel, uvec4 discrete) {
    return (texel & discrete) | (floatBitsToUint(sc_near(uintBitsToFloat(texel))) & ~discrete);
}
#else
vec4 sc_in_range(vec4 texel) {
    return sc_near(texel);
}
#endif
#endif

// Four texels by their weights.
vec4 sc_weighted(vec4 a, vec4 b, vec4 c, vec4 d, vec4 weights) {
    return weights.x * a + weights.y * b + weights.z * c + weights.w * d;
}

// The same of those that have a weight. The others may hold NaN, and 0 times NaN is NaN.
vec4 sc_chosen(vec4 a, vec4 b, vec4 c, vec4 d, vec4 weights) {
    vec4 sum = weights.x > 0.0 ? weights.x * a : vec4(0.0);
    sum += weights.y > 0.0 ? weights.y * b : vec4(0.0);
    sum += weights.z > 0.0 ? weights.z * c : vec4(0.0);
    return sum + (weights.w > 0.0 ? weights.w * d : vec4(0.0));
}

#if SC_CUBIC
// The weights of four texels in a row, for a place that lies a part of the way from the second to
// the third. A place right on a texel is that texel.
vec4 sc_kernel(float part) {
    if (part == 0.0) {
        return vec4(0.0, 1.0, 0.0, 0.0);
    }
    vec4 x = vec4(1.0 + part, part, 1.0 - part, 2.0 - part);
#if SC_FILTER_LANCZOS2
    // sinc(x) sinc(x / 2), but for a factor
    x *= 1.5707963267948966;
    vec4 weights = sin(2.0 * x) * sin(x) / (x * x);
    return weights / dot(weights, vec4(1.0));
#else
    // Mitchell and Netravali 1988, B = C = 1/3
    vec2 inner = x.yz;
    vec2 outer = x.xw;
    inner = ((7.0 * inner - 12.0) * inner * inner + 16.0 / 3.0) / 6.0;
    outer = (((-7.0 / 3.0 * outer + 12.0) * outer - 20.0) * outer + 32.0 / 3.0) / 6.0;
    return vec4(outer.x, inner, outer.y);
#endif
}

// Adds the four texels of a row to a sum, and gives their depths; own: are all of this object?
vec4 sc_row(ivec4 columns, int row, vec4 weights, SC_IN_OUT_SUMS) {
    SC_TEXEL a = SC_READ(sc_cache, ivec2(columns.x, row), SC_DISCRETE_1);
    SC_TEXEL b = SC_READ(sc_cache, ivec2(columns.y, row), SC_DISCRETE_1);
    SC_TEXEL c = SC_READ(sc_cache, ivec2(columns.z, row), SC_DISCRETE_1);
    SC_TEXEL d = SC_READ(sc_cache, ivec2(columns.w, row), SC_DISCRETE_1);
    sum += sc_weighted(SC_FLOATS(a), SC_FLOATS(b), SC_FLOATS(c), SC_FLOATS(d), weights);
#if SC_TARGETS == 2
    SC_TEXEL a_2 = SC_READ(sc_cache_2, ivec2(columns.x, row), SC_DISCRETE_2);
    SC_TEXEL b_2 = SC_READ(sc_cache_2, ivec2(columns.y, row), SC_DISCRETE_2);
    SC_TEXEL c_2 = SC_READ(sc_cache_2, ivec2(columns.z, row), SC_DISCRETE_2);
    SC_TEXEL d_2 = SC_READ(sc_cache_2, ivec2(columns.w, row), SC_DISCRETE_2);
    sum_2 += sc_weighted(SC_FLOATS(a_2), SC_FLOATS(b_2), SC_FLOATS(c_2), SC_FLOATS(d_2), weights);
#endif
#if SC_IDS
    own = own && SC_IDS_OF_FOUR == ivec4(sc_object);
#endif
    return SC_DEPTHS;
}

// A filtered texel within the range of four others: what a sharp filter adds to waves it would add
// again in each frame, and in the end nothing else would be left.
SC_TEXEL sc_within(SC_TEXEL a, SC_TEXEL b, SC_TEXEL c, SC_TEXEL d, vec4 sum) {
    vec4 least = min(min(SC_FLOATS(a), SC_FLOATS(b)), min(SC_FLOATS(c), SC_FLOATS(d)));
    vec4 most = max(max(SC_FLOATS(a), SC_FLOATS(b)), max(SC_FLOATS(c), SC_FLOATS(d)));
    return SC_OF_FLOATS(clamp(sum, least, most));
}
#endif
