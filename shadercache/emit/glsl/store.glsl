// What a pass writes into the cache: the payloads, padded to three channels, and the depth; what
// does not fit there goes to the second texture. Where not every fragment has a payload (SC_WHOLE) a
// texel may be empty, which matches nothing; so does one that lacks one of several payloads
// (SC_MASKED).

#if SC_SURFACE
in vec4 sc_current;  // clip-space position in this frame
#elif SC_OWN_CURRENT
vec4 sc_current;  // the same, by the user's function
#endif
out SC_TEXEL sc_store;  // the texel of the cache
#if SC_TARGETS == 2
out SC_TEXEL sc_store_2;
#endif

uniform int sc_object;   // number of the object that is drawn
uniform int sc_mask;     // 1: the draw reuses nothing; 2: and nobody reuses it
uniform float sc_limit;  // the largest value that is reused
uniform float sc_least;  // the smallest one above zero that it surely holds

#if SC_AGE
uniform int sc_reset;   // 1 in a frame that follows a reset, else 0
uniform int sc_period;  // frames between two refreshes of a pixel
uniform int sc_block;   // edge in pixels of the squares that are refreshed together
float sc_age = 0.0;     // frames since the payload was computed

// After a reset all payloads are new. They start with different ages, or all would be too old in the
// same frame.
void sc_stagger() {
    if (sc_reset != 0) {
        uvec2 block = uvec2(gl_FragCoord.xy / float(sc_block));
        uint hashed = (block.x * 1973u + block.y * 9277u + 26699u) * 0x9E3779B9u;
        hashed = (hashed ^ (hashed >> 15)) * 0x85EBCA6Bu;
        sc_age = float(((hashed >> 16) * uint(sc_period)) >> 16);
    }
}
#endif

SC_DECLARE_PAYLOADS;
#if SC_WHOLE
bool sc_reuse = false;  // are there payloads from the cache?
SC_DECLARE_VALID;       // is there a payload to store?
#endif
bool sc_lacks = false;  // was a payload needed, and none there?
bool sc_moved = false;  // is the payload not just that of this place?

#if SC_ASIDE && SC_LOOKS
#define SC_MARKED_DEPTH SC_MARKED(SC_KEPT_DEPTH)
#else
#define SC_MARKED_DEPTH SC_KEPT_DEPTH
#endif
#if SC_MASK
#define SC_OWN_DEPTH (sc_mask == 2 ? SC_NO_DEPTH : SC_MARKED_DEPTH)
#else
#define SC_OWN_DEPTH SC_MARKED_DEPTH
#endif

SC_TEXEL sc_texel() {
#if SC_MASKED
    // The third of three passes takes from here what there is; the next frame needs all or nothing.
    return SC_TEXEL(SC_PACKED_1, SC_VALID ? SC_OWN_DEPTH : SC_NO_DEPTH);
#else
#if SC_WHOLE
    if (!SC_VALID) {
        return SC_EMPTY;
    }
#endif
    return SC_TEXEL(SC_PACKED_1, SC_OWN_DEPTH);
#endif
}

#if SC_TARGETS == 2
SC_TEXEL sc_texel_2() {
#if SC_WHOLE && !SC_MASKED
    if (!SC_VALID) {
        return SC_TEXEL(0);
    }
#endif
    return SC_TEXEL(SC_PACKED_2);
}
#endif

#if SC_GUARDS && !SC_BITS
// Numbers as near as half floats can hold them. Infinity and NaN stay.
vec4 sc_held(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    vec4 held = mix(clamp(values, vec4(-sc_limit), vec4(sc_limit)), values,
            greaterThanEqual(sizes, uvec4(0x7F800000u)));
    return mix(values, held, greaterThan(sizes, uvec4(floatBitsToUint(sc_limit))));
}

void sc_hold() {
    if (sc_limit <= SC_MOST_OF_HALF) {
        sc_store = sc_held(sc_store);
#if SC_TARGETS == 2
        sc_store_2 = sc_held(sc_store_2);
#endif
    }
}
#endif

#if SC_GUARD_MISS
// Can the cache not hold a value? The bits are compared: they are in the order of the sizes, NaN lies
// above infinity, and no driver can make less of them than they are.
bool sc_unfit(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    return any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit))))
            || any(lessThan(sizes - 1u, uvec4(least)));
}

// Marks a texel that must not be reused: the next frame computes it anew. The third of three passes
// reads it in this one, so it holds what was computed, or what comes nearest of larger numbers.
void sc_guard() {
    bool unfit = sc_unfit(SC_FLOATS(SC_ONLY_FLOATS(sc_store, SC_DISCRETE_1)));
#if SC_TARGETS == 2
    unfit = unfit || sc_unfit(SC_FLOATS(SC_ONLY_FLOATS(sc_store_2, SC_DISCRETE_2)));
#endif
    if (unfit) {
#if !SC_BITS
        sc_hold();
#endif
        sc_store.w = SC_POISON_DEPTH;
    }
}
#elif SC_GUARDS
void sc_guard() {
    sc_hold();
}
#endif
