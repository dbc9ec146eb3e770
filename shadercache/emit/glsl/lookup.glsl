// The look-up in the cache of the previous frame. Words in capitals: see macros.glsl and depth.glsl.

#if SC_SURFACE
in vec4 sc_current;   // clip-space position in this frame
in vec4 sc_previous;  // clip-space position of the same surface point in the previous frame
#elif SC_OWN_CURRENT
vec4 sc_current;  // clip-space position in this frame, by the user's function
#endif

uniform SC_SAMPLER sc_cache;    // what the previous frame stored: payload and depth
#if SC_TARGETS == 2
uniform SC_SAMPLER sc_cache_2;  // the rest of the payload
#endif
uniform float sc_epsilon;    // greatest accepted difference of depths, relative to the depth
uniform float sc_resolution;     // what depths are rounded by where they are kept, relative to them
uniform float sc_unit;           // 2 near far / (far - near), what 1/w is in depths from -1 to 1
uniform float sc_magnification;  // how many times larger a surface may have become
uniform int sc_object;           // number of the object that is drawn
uniform int sc_mask;             // 1: the draw reuses nothing; 2: and nobody reuses it
#if SC_AGE
float sc_age = 0.0;  // frames since the payload was computed
#endif

uniform ivec4 sc_viewport;           // left, bottom, width and height of what is drawn into, in pixels
uniform ivec4 sc_previous_viewport;  // the same of the previous frame

// Words for where the previous frame lies in the cache, and for a pixel's place there.
#if SC_VIEWPORT
#define SC_LAST sc_previous_viewport.xy + sc_previous_viewport.zw - 1
#define SC_FIRST sc_previous_viewport.xy
#define SC_FIRST_OF(axis) sc_previous_viewport.axis
#define SC_LOWEST vec2(sc_previous_viewport.xy)
#define SC_EXTENT vec2(sc_previous_viewport.zw)
#define SC_PIXEL pixel
#define SC_OWN_PLACE (2.0 * (gl_FragCoord.xy - vec2(sc_viewport.xy)) / vec2(sc_viewport.zw) - 1.0)
#else
#define SC_LAST textureSize(sc_cache, 0) - 1
#define SC_FIRST ivec2(0)
#define SC_FIRST_OF(axis) 0
#define SC_LOWEST vec2(0.0)
#define SC_EXTENT vec2(last + 1)
#define SC_PIXEL gl_FragCoord.xy
#define SC_OWN_PLACE (2.0 * gl_FragCoord.xy / vec2(last + 1) - 1.0)
#endif

SC_DECLARE_PAYLOADS;
bool sc_moved = false;  // is the payload not just that of this place?

#if SC_SCREEN
// What the previous frame stored at this pixel, if the surface is as far away as it was there.
// Returns one of the outcomes.
int sc_look_up(SC_OUT_TEXELS) {
    ivec2 own = ivec2(gl_FragCoord.xy);
    texel = SC_READ(sc_cache, own, SC_DISCRETE_1);
#if SC_TARGETS == 2
    texel_2 = SC_READ(sc_cache_2, own, SC_DISCRETE_2);
#endif
#if !SC_AGE
    if (sc_due()) {
        return SC_REFRESH;
    }
#endif
#if SC_MASK
    if (sc_mask != 0) {
        return SC_OPTED_OUT;
    }
#endif
    // A comparison with NaN is false and so a miss.
    if (!(abs(SC_FLOAT(texel.w) - SC_DEPTH_OF_PIXEL) <= SC_TOLERANCE * (SC_UNIT))) {
        return SC_MISS_OF_ONE;
    }
#if SC_IDS
    if (SC_ID_IN(texel, texel_2) != sc_object) {
        return SC_ID;
    }
#endif
    return SC_FOUND;
}
#else
// Reprojection: where the surface point was, whether it was seen there, and what was stored.
// Returns one of the outcomes.
int sc_look_up(SC_OUT_TEXELS) {
    ivec2 last = SC_LAST;
#if SC_VIEWPORT
    // The pixel's place in the previous viewport. While that does not change it is exactly its own.
    vec2 pixel = (gl_FragCoord.xy - vec2(sc_viewport.xy)) * (SC_EXTENT / vec2(sc_viewport.zw)) + SC_LOWEST;
#endif
#if SC_USER
    SC_LOCATE
    vec4 sc_previous = scPreviousClip();
#endif
#if SC_PIXEL_IS_CURRENT
    vec2 motion = sc_previous.xy / sc_previous.w - SC_OWN_PLACE;
    // The user's function comes to the pixel's own place by another way, up to rounding: what is
    // less than a 256th of a pixel is no motion.
    if (all(lessThan(0.5 * SC_EXTENT * abs(motion), vec2(1.0 / 256.0)))) {
        motion = vec2(0.0);
    }
#else
    vec2 motion = sc_previous.xy / sc_previous.w - sc_current.xy / sc_current.w;
#endif
    vec2 corner = SC_PIXEL - 0.5 + 0.5 * SC_EXTENT * motion;
#if SC_SLOPED
    // How the expected depth changes from pixel to pixel. Ahead of every exit, as derivatives are.
    vec2 slope = vec2(dFdx(SC_EXPECTED), dFdy(SC_EXPECTED)) / (SC_UNIT);
#endif
#if SC_MAGNIFICATION
    vec2 across = dFdx(corner);
    vec2 up = dFdy(corner);
#endif
    // At rest the motion is exactly zero: all four texels are the pixel's own, nothing is filtered.
    vec2 whole = floor(corner);
    vec2 part = corner - whole;
    ivec2 near = clamp(ivec2(whole), SC_FIRST, last);
    ivec2 far = min(near + ivec2(ceil(part)), last);
#if SC_SINGLE
    ivec2 own = ivec2(part.x < 0.5 ? near.x : far.x, part.y < 0.5 ? near.y : far.y);
    texel = SC_READ(sc_cache, own, SC_DISCRETE_1);
#if SC_TARGETS == 2
    texel_2 = SC_READ(sc_cache_2, own, SC_DISCRETE_2);
#endif
#else
    SC_TEXEL a = SC_READ(sc_cache, near, SC_DISCRETE_1);
    SC_TEXEL b = SC_READ(sc_cache, ivec2(far.x, near.y), SC_DISCRETE_1);
    SC_TEXEL c = SC_READ(sc_cache, ivec2(near.x, far.y), SC_DISCRETE_1);
    SC_TEXEL d = SC_READ(sc_cache, far, SC_DISCRETE_1);
#if SC_TARGETS == 2
    SC_TEXEL a_2 = SC_READ(sc_cache_2, near, SC_DISCRETE_2);
    SC_TEXEL b_2 = SC_READ(sc_cache_2, ivec2(far.x, near.y), SC_DISCRETE_2);
    SC_TEXEL c_2 = SC_READ(sc_cache_2, ivec2(near.x, far.y), SC_DISCRETE_2);
    SC_TEXEL d_2 = SC_READ(sc_cache_2, far, SC_DISCRETE_2);
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
#endif
#if !SC_AGE
    if (sc_due()) {
        return SC_REFRESH;
    }
#endif
#if SC_MASK
    if (sc_mask != 0) {
        return SC_OPTED_OUT;
    }
#endif
    // All four texels lie in the cache; a point behind the camera was not seen.
    if (!(sc_previous.w > 0.0 && all(greaterThanEqual(corner, SC_LOWEST))
            && all(lessThanEqual(corner, vec2(last))))) {
        return SC_OUTSIDE;
    }
#if SC_MAGNIFICATION
    // The area in the previous frame that a pixel shows.
    if (!(abs(across.x * up.y - across.y * up.x) * sc_magnification * sc_magnification >= 1.0)) {
        return SC_MAGNIFIED;
    }
#endif
#if SC_SINGLE
    // The texel lies beside the place; so does what its depth should be.
    vec2 aside = vec2(own) - corner;
    if (!(abs(SC_OFF(SC_FLOAT(texel.w)) - dot(slope, aside)) <= SC_TOLERANCE)) {
        return SC_MISS_OF_ONE;
    }
#if SC_IDS
    if (SC_ID_IN(texel, texel_2) != sc_object) {
        return SC_ID;
    }
#endif
    return SC_FOUND;
#else
#if SC_ASIDE
    // What each texel is off, where the surface slopes on as it does at the pixel. Along an edge those
    // that fit are taken without the others, and what is made of them is marked.
    vec4 aside = SC_OFF(SC_DEPTHS) - slope.x * vec4(-part.x, 1.0 - part.x, -part.x, 1.0 - part.x)
            - slope.y * vec4(-part.y, -part.y, 1.0 - part.y, 1.0 - part.y);
    bvec4 moved = lessThan(SC_SIGNED_DEPTHS, vec4(0.0));
    vec4 single = vec4(lessThanEqual(abs(aside), vec4(SC_TOLERANCE))) * vec4(not(moved));
#if SC_IDS
    single *= vec4(equal(SC_IDS_OF_FOUR, ivec4(sc_object)));
#endif
    vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x)
            * vec4(1.0 - part.y, 1.0 - part.y, part.y, part.y);
    float blended = dot(weights, SC_DEPTHS);
#if SC_IDS
    bool near_enough = all(lessThanEqual(abs(SC_OFF(SC_DEPTHS)), vec4(SC_ROUGHLY)));
    bool one_surface = near_enough && SC_IDS_OF_FOUR == ivec4(sc_object);
#else
    bool one_surface = all(lessThanEqual(abs(SC_OFF(SC_DEPTHS)), vec4(SC_ROUGHLY)));
#endif
    bool agrees = one_surface && abs(SC_OFF(blended)) <= SC_TOLERANCE;
    // A fold: one of its sides must not be taken for the other.
    if (one_surface && !agrees) {
        return SC_DEPTH;
    }
    bool marked = dot(weights, vec4(moved)) > 0.0;
#endif
#if SC_FILTER_BILATERAL
    if (!agrees) {
        // What fits of the four, as if the rest were not there.
        weights *= single;
        float total = dot(weights, vec4(1.0));
        if (!(total >= SC_LEAST_WEIGHT)) {
            return SC_MISS_OF_FOUR;
        }
        weights /= total;
        texel = SC_MERGED(SC_OF_FLOATS(SC_CHOSEN(a, b, c, d)), a, SC_DISCRETE_1);
#if SC_TARGETS == 2
        texel_2 = SC_MERGED(SC_OF_FLOATS(SC_CHOSEN(a_2, b_2, c_2, d_2)), a_2, SC_DISCRETE_2);
#endif
        marked = true;
    }
#elif SC_FALLS_BACK
    if (!agrees) {
        // The nearest texel by itself.
        bool right = part.x >= 0.5;
        bool top = part.y >= 0.5;
        if ((top ? (right ? single.w : single.z) : (right ? single.y : single.x)) == 0.0) {
            return SC_MISS_OF_FOUR;
        }
        texel = top ? (right ? d : c) : (right ? b : a);
#if SC_TARGETS == 2
        texel_2 = top ? (right ? d_2 : c_2) : (right ? b_2 : a_2);
#endif
        marked = true;
    }
#else
    // The blended depth must agree closely, each single one roughly: else a front and a back could
    // blend to just the right depth. A comparison with NaN is false and so a miss.
    vec4 each = abs(SC_OFF(SC_DEPTHS));
    if (!(abs(SC_OFF(SC_FLOAT(texel.w))) <= SC_TOLERANCE
            && all(lessThanEqual(each, vec4(SC_ROUGHLY))))) {
        return SC_MISS_OF_FOUR;
    }
#if SC_IDS
    // A filter that takes a little of another object passes the test of depths where they touch.
    if (SC_IDS_OF_FOUR != ivec4(sc_object)) {
        return SC_ID;
    }
#endif
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
#if SC_CUBIC
    // Sixteen texels, where all of them show the surface; else the four will do.
    if (part != vec2(0.0) SC_AND_AGREES) {
        ivec4 columns = clamp(near.x + ivec4(-1, 0, 1, 2), ivec4(SC_FIRST_OF(x)), ivec4(last.x));
        ivec4 lines = clamp(near.y + ivec4(-1, 0, 1, 2), ivec4(SC_FIRST_OF(y)), ivec4(last.y));
        vec4 weights = sc_kernel(part.x);
        vec4 heights = sc_kernel(part.y);
        SC_DECLARE_SUMS;
        vec4 first = sc_row(columns, lines.x, heights.x * weights, SC_SUMS);
        vec4 second = sc_row(columns, lines.y, heights.y * weights, SC_SUMS);
        vec4 third = sc_row(columns, lines.z, heights.z * weights, SC_SUMS);
        vec4 fourth = sc_row(columns, lines.w, heights.w * weights, SC_SUMS);
        vec4 least = min(min(first, second), min(third, fourth));
        vec4 most = max(max(first, second), max(third, fourth));
        if (all(lessThanEqual(abs(SC_OFF(least)), vec4(SC_ROUGHLY)))
                && all(lessThanEqual(abs(SC_OFF(most)), vec4(SC_ROUGHLY))) SC_AND_OWN) {
            sum.w = SC_FLOAT(texel.w);
            texel = SC_MERGED(sc_within(a, b, c, d, sum), texel, SC_DISCRETE_1);
#if SC_TARGETS == 2
            texel_2 = SC_MERGED(sc_within(a_2, b_2, c_2, d_2, sum_2), texel_2, SC_DISCRETE_2);
#endif
        }
    }
#endif
#if SC_ASIDE && SC_AGE
    int outcome = SC_FOUND;
    sc_moved = marked && outcome == SC_HIT;
    return outcome;
#elif SC_ASIDE
    sc_moved = marked;
    return SC_HIT;
#else
    return SC_FOUND;
#endif
#endif
}
#endif
