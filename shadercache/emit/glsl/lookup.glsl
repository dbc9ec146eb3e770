// The look-up in the cache of the previous frame. Words in capitals: see macros.glsl.

#if SC_SURFACE
in vec4 sc_current;   // clip-space position in this frame
in vec4 sc_previous;  // clip-space position of the same surface point in the previous frame
#elif SC_OWN_CURRENT
vec4 sc_current;  // clip-space position in this frame, by the user's function
#endif

uniform SC_SAMPLER sc_cache;    // what the previous frame stored: payload and 1/w
#if SC_TARGETS == 2
uniform SC_SAMPLER sc_cache_2;  // the rest of the payload
#endif
uniform float sc_epsilon;    // greatest accepted difference of depths, relative to the depth
#if SC_IDS
uniform int sc_object;       // number of the object that is drawn
#endif
#if SC_AGE
float sc_age = 0.0;  // frames since the payload was computed
#endif

SC_DECLARE_PAYLOADS;

#if SC_SCREEN
// What the previous frame stored at this pixel, if the surface is as far away as it was there.
// Returns SC_HIT, SC_REFRESH, SC_DEPTH, SC_ID or SC_OLD.
int sc_look_up(SC_OUT_TEXELS) {
    ivec2 own = ivec2(gl_FragCoord.xy);
    texel = texelFetch(sc_cache, own, 0);
#if SC_TARGETS == 2
    texel_2 = texelFetch(sc_cache_2, own, 0);
#endif
#if !SC_AGE
    if (sc_due()) {
        return SC_REFRESH;
    }
#endif
    // Both depths are 1/w. A comparison with NaN is false and so a miss.
    if (!(abs(SC_FLOAT(texel.w) - gl_FragCoord.w) <= sc_epsilon * gl_FragCoord.w)) {
        return SC_DEPTH;
    }
#if SC_IDS
    if (SC_ID_IN(texel, texel_2) != sc_object) {
        return SC_ID;
    }
#endif
#if SC_AGE
    return sc_judge(SC_AGE_IN(texel, texel_2));  // the mean of all that the filter took
#else
    return SC_HIT;
#endif
}
#else
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

// Reprojection: where the surface point was, whether it was seen there, and what was stored.
// Returns SC_HIT, SC_REFRESH, SC_OUTSIDE, SC_DEPTH, SC_ID or SC_OLD.
int sc_look_up(SC_OUT_TEXELS) {
    ivec2 last = textureSize(sc_cache, 0) - 1;
#if SC_USER
    SC_LOCATE
    vec4 sc_previous = scPreviousClip();
#endif
#if SC_PIXEL_IS_CURRENT
    vec2 motion = sc_previous.xy / sc_previous.w - (2.0 * gl_FragCoord.xy / vec2(last + 1) - 1.0);
    // The user's function comes to the pixel's own place by another way, up to rounding: what is
    // less than a 256th of a pixel is no motion.
    if (all(lessThan(0.5 * vec2(last + 1) * abs(motion), vec2(1.0 / 256.0)))) {
        motion = vec2(0.0);
    }
#else
    vec2 motion = sc_previous.xy / sc_previous.w - sc_current.xy / sc_current.w;
#endif
    vec2 corner = gl_FragCoord.xy - 0.5 + 0.5 * vec2(last + 1) * motion;
    // At rest the motion is exactly zero: all four texels are the pixel's own, nothing is filtered.
    vec2 whole = floor(corner);
    vec2 part = corner - whole;
    ivec2 near = clamp(ivec2(whole), ivec2(0), last);
    ivec2 far = min(near + ivec2(ceil(part)), last);
    SC_TEXEL a = texelFetch(sc_cache, near, 0);
    SC_TEXEL b = texelFetch(sc_cache, ivec2(far.x, near.y), 0);
    SC_TEXEL c = texelFetch(sc_cache, ivec2(near.x, far.y), 0);
    SC_TEXEL d = texelFetch(sc_cache, far, 0);
#if SC_TARGETS == 2
    SC_TEXEL a_2 = texelFetch(sc_cache_2, near, 0);
    SC_TEXEL b_2 = texelFetch(sc_cache_2, ivec2(far.x, near.y), 0);
    SC_TEXEL c_2 = texelFetch(sc_cache_2, ivec2(near.x, far.y), 0);
    SC_TEXEL d_2 = texelFetch(sc_cache_2, far, 0);
#endif
#if SC_BITS
    texel = sc_blend(a, b, c, d, part, SC_DISCRETE_1);
#if SC_TARGETS == 2
    texel_2 = sc_blend(a_2, b_2, c_2, d_2, part, SC_DISCRETE_2);
#endif
#else
    texel = mix(mix(a, b, part.x), mix(c, d, part.x), part.y);
#if SC_TARGETS == 2
    texel_2 = mix(mix(a_2, b_2, part.x), mix(c_2, d_2, part.x), part.y);
#endif
#endif
#if !SC_AGE
    if (sc_due()) {
        return SC_REFRESH;
    }
#endif
    // All four texels lie in the cache; a point behind the camera was not seen.
    if (!(sc_previous.w > 0.0 && all(greaterThanEqual(corner, vec2(0.0)))
            && all(lessThanEqual(corner, vec2(last))))) {
        return SC_OUTSIDE;
    }
    // All depths are 1/w. The blended one must agree closely, each single one roughly: else a front
    // and a back could blend to just the right depth. A comparison with NaN is false and so a miss.
    vec4 each = abs(vec4(SC_FLOAT(a.w), SC_FLOAT(b.w), SC_FLOAT(c.w), SC_FLOAT(d.w)) * sc_previous.w - 1.0);
    if (!(abs(SC_FLOAT(texel.w) * sc_previous.w - 1.0) <= sc_epsilon
            && all(lessThanEqual(each, vec4(SC_SPREAD * sc_epsilon))))) {
        return SC_DEPTH;
    }
#if SC_IDS
    // A filter that takes a little of another object passes the test of depths where they touch.
    ivec4 ids = ivec4(SC_ID_IN(a, a_2), SC_ID_IN(b, b_2), SC_ID_IN(c, c_2), SC_ID_IN(d, d_2));
    if (ids != ivec4(sc_object)) {
        return SC_ID;
    }
#endif
    // No integer lies between two others: where the texels differ, none of them is right.
#if SC_ANY_DISCRETE_1
    if (!sc_same(a, b, c, d, SC_DISCRETE_1)) {
        return SC_DEPTH;
    }
#endif
#if SC_ANY_DISCRETE_2
    if (!sc_same(a_2, b_2, c_2, d_2, SC_DISCRETE_2)) {
        return SC_DEPTH;
    }
#endif
#if SC_AGE
    return sc_judge(SC_AGE_IN(texel, texel_2));  // the mean of all that the filter took
#else
    return SC_HIT;
#endif
}
#endif
