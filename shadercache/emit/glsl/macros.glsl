// Words that the other files use. Set before, by emit/layout.py: SC_TARGETS (1 or 2 textures),
// SC_BITS (do they hold unsigned integers?), SC_WHOLE (may there be no payload?), SC_MASKED (and are
// there several?), SC_DECLARE_PAYLOADS (their variables), SC_PACKED_1 and SC_PACKED_2 (their channels
// in each texel, without the depth), SC_UNPACK (the assignments to them from the texels),
// SC_CHANNELS (the texel's channels that are the payload, where it is one scalar or vector of floats
// in one texel), SC_DECLARE_VALID, SC_SET_VALID and SC_VALID (whether there is a payload, for each of
// them; are there all?), SC_DISCRETE_1 and SC_DISCRETE_2 (masks of the channels that hold integers or
// booleans), SC_ANY_DISCRETE_1 and SC_ANY_DISCRETE_2 (are there any?), SC_LOCAL_1 and
// SC_LOCAL_2 (names of main's variables: two texels), SC_ID_IN(first, second) (an extra scalar of a
// texel, from its two parts); set by emit/runtime.py: SC_SURFACE, SC_SCREEN
// and SC_USER (one of them is 1: the mapping), SC_OWN_CURRENT (does the user say where the pixel is?),
// one for each choice of CacheOptions, and SC_LOOKS (does the pass look anything up?).

// Is the pixel's own place the clip-space position in this frame?
#define SC_PIXEL_IS_CURRENT (SC_SCREEN || SC_USER && !SC_OWN_CURRENT)

// Depths. What is kept of them is 1/w (times 16), z/w or w; SC_DEPTH_OF_PIXEL is that of the pixel,
// SC_EXPECTED that of its point in the previous frame, SC_UNIT what 1/w is in its units, and SC_OFF
// how far a kept depth is from the expected one in these.
#if SC_DEPTH_NDC
#if SC_PIXEL_IS_CURRENT
#define SC_DEPTH_OF_PIXEL 2.0 * gl_FragCoord.z - 1.0
#else
#define SC_DEPTH_OF_PIXEL sc_current.z / sc_current.w
#endif
#if SC_SCREEN
#define SC_UNIT sc_unit * gl_FragCoord.w
#else
#define SC_UNIT sc_unit / sc_previous.w
#endif
#define SC_EXPECTED sc_previous.z / sc_previous.w
#define SC_OFF(kept) ((kept * sc_previous.w - sc_previous.z) / sc_unit)
#elif SC_DEPTH_LINEAR
#if SC_PIXEL_IS_CURRENT
#define SC_DEPTH_OF_PIXEL 1.0 / gl_FragCoord.w
#else
#define SC_DEPTH_OF_PIXEL sc_current.w
#endif
#if SC_SCREEN
#define SC_UNIT 1.0 / gl_FragCoord.w
#else
#define SC_UNIT sc_previous.w
#endif
#define SC_EXPECTED sc_previous.w
#define SC_OFF(kept) (kept / sc_previous.w - 1.0)
#else
// Half floats are as precise as that from w = 2.4e-4 to 2.6e5; of 1/w only up to w = 1.6e4.
#define SC_SCALE 16.0
#define SC_INVERSE_SCALE 0.0625
#if SC_PIXEL_IS_CURRENT
#define SC_DEPTH_OF_PIXEL SC_SCALE * gl_FragCoord.w
#else
#define SC_DEPTH_OF_PIXEL SC_SCALE / sc_current.w
#endif
#if SC_SCREEN
#define SC_UNIT SC_SCALE * gl_FragCoord.w
#else
#define SC_UNIT SC_SCALE / sc_previous.w
#endif
#define SC_EXPECTED SC_SCALE / sc_previous.w
#define SC_OFF(kept) (SC_INVERSE_SCALE * sc_previous.w * kept - 1.0)
#endif

// What a kept depth may be off, in SC_UNIT: the depth at the very place, and that of a texel of a
// filter.
#if SC_TOLERANCE_AKELEY_SU
#if SC_DEPTH_NDC && SC_SCREEN
#define SC_TOLERANCE (SC_INTERPOLATION + sc_resolution / (SC_UNIT))
#elif SC_DEPTH_NDC
#define SC_TOLERANCE (SC_INTERPOLATION + sc_resolution * abs(sc_previous.z) / sc_unit)
#else
#define SC_TOLERANCE (SC_INTERPOLATION + sc_resolution)
#endif
#elif SC_TOLERANCE_FIXED
#define SC_TOLERANCE (sc_epsilon / (SC_UNIT))
#else
#define SC_TOLERANCE sc_epsilon
#endif
#if SC_TOLERANCE_RELATIVE
#define SC_ROUGHLY SC_SPREAD * sc_epsilon
#else
#define SC_ROUGHLY SC_SPREAD * SC_EPSILON
#endif

// Filters: do they read one texel, or sixteen? Are texels tested where the surface slopes on?
#define SC_ANY_DISCRETE (SC_ANY_DISCRETE_1 || SC_ANY_DISCRETE_2)
#define SC_SINGLE (SC_FILTER_NEAREST && !SC_ANY_DISCRETE)
#define SC_CUBIC (SC_FILTER_LANCZOS2 || SC_FILTER_MITCHELL)
#define SC_FALLS_BACK (SC_FALLBACK && !SC_FILTER_NEAREST && !SC_FILTER_BILATERAL && !SC_ANY_DISCRETE)
#define SC_ASIDE (SC_FILTER_BILATERAL || SC_FALLS_BACK)
#define SC_SLOPED (SC_SINGLE || SC_ASIDE)
#if SC_ASIDE
#define SC_AND_AGREES && agrees
#else
#define SC_AND_AGREES
#endif
// Where filters make do with a part of their texels, what they make is marked by a negative depth.
#define SC_SIGNED_DEPTHS vec4(SC_FLOAT(a.w), SC_FLOAT(b.w), SC_FLOAT(c.w), SC_FLOAT(d.w))
#if SC_ASIDE
#define SC_DEPTHS abs(SC_SIGNED_DEPTHS)
#else
#define SC_DEPTHS SC_SIGNED_DEPTHS
#endif
#define SC_IDS_OF_FOUR \
    ivec4(SC_ID_IN(a, a_2), SC_ID_IN(b, b_2), SC_ID_IN(c, c_2), SC_ID_IN(d, d_2))
#if SC_GUARD_MISS
#define SC_MISS_OF_ONE (texel.w == SC_POISON_DEPTH ? SC_POISON : SC_DEPTH)
#define SC_NONE_FITS (a.w == SC_POISON_DEPTH || b.w == SC_POISON_DEPTH \
    || c.w == SC_POISON_DEPTH || d.w == SC_POISON_DEPTH ? SC_POISON : SC_DEPTH)
#else
#define SC_MISS_OF_ONE SC_DEPTH
#define SC_NONE_FITS SC_DEPTH
#endif
#if SC_IDS && SC_ASIDE
#define SC_MISS_OF_FOUR (near_enough ? SC_ID : SC_NONE_FITS)
#else
#define SC_MISS_OF_FOUR SC_NONE_FITS
#endif
#define SC_CHOSEN(a, b, c, d) \
    sc_chosen(SC_FLOATS(a), SC_FLOATS(b), SC_FLOATS(c), SC_FLOATS(d), weights)
#if SC_IDS
#define SC_OWN , inout bool own
#define SC_THE_OWN , own
#define SC_DECLARE_OWN ; bool own = true
#define SC_AND_OWN && own
#else
#define SC_OWN
#define SC_THE_OWN
#define SC_DECLARE_OWN
#define SC_AND_OWN
#endif

// What stands in front of look-up and store: where is the pixel?
#if SC_OWN_CURRENT
#define SC_LOCATE sc_current = scCurrentClip();
#else
#define SC_LOCATE
#endif

#if SC_BITS
#define SC_TEXEL uvec4
#define SC_SAMPLER usampler2D
#define SC_MARKED(depth) depth | (sc_moved ? 0x80000000u : 0u)
#define SC_FLOAT(channel) uintBitsToFloat(channel)
#define SC_FLOATS(texel) uintBitsToFloat(texel)
#define SC_OF_FLOATS(floats) floatBitsToUint(floats)
#define SC_MERGED(floats, texel, discrete) (texel & discrete) | (floats & ~discrete)
#define SC_ONLY_FLOATS(texel, discrete) texel & ~discrete
#define SC_KEPT_DEPTH floatBitsToUint(SC_DEPTH_OF_PIXEL)
#else
#define SC_TEXEL vec4
#define SC_SAMPLER sampler2D
#define SC_MARKED(depth) (sc_moved ? -(depth) : depth)
#define SC_FLOAT(channel) channel
#define SC_FLOATS(texel) texel
#define SC_OF_FLOATS(floats) floats
#define SC_MERGED(floats, texel, discrete) floats
#define SC_ONLY_FLOATS(texel, discrete) texel
#define SC_KEPT_DEPTH SC_DEPTH_OF_PIXEL
#endif

// Depths that match nothing: of an empty texel, and of one whose payload is not to be reused. Where a
// sign is a mark that one is negative too, so that no slope can lead to it: it is never taken alone.
#if SC_BITS && SC_DEPTH_NDC
#define SC_NO_DEPTH 0x40000000u
#define SC_EMPTY uvec4(0u, 0u, 0u, SC_NO_DEPTH)
#elif SC_BITS
#define SC_NO_DEPTH 0u
#define SC_EMPTY uvec4(0u)
#elif SC_ASIDE
#define SC_NO_DEPTH 0.0
#define SC_EMPTY vec4(0.0)
#elif SC_DEPTH_NDC
#define SC_NO_DEPTH 2.0
#define SC_EMPTY vec4(0.0, 0.0, 0.0, SC_NO_DEPTH)
#else
#define SC_NO_DEPTH -1.0
#define SC_EMPTY vec4(0.0, 0.0, 0.0, SC_NO_DEPTH)
#endif
#if SC_BITS
#define SC_POISON_DEPTH 0xFF000000u
#elif SC_ASIDE && SC_DEPTH_LINEAR
#define SC_POISON_DEPTH -0.00006103515625
#else
#define SC_POISON_DEPTH -SC_MOST_OF_HALF
#endif

// SC_FOUND is what a look-up says whose texels have passed: with ages (the mean of all that the
// filter took) they may be too old yet.
#if SC_AGE
#define SC_AGING sc_stagger();
#define SC_FOUND sc_judge(SC_AGE_IN(texel, texel_2))
#else
#define SC_AGING
#define SC_FOUND SC_HIT
#endif

#if SC_TARGETS == 2
#define SC_TEXELS SC_LOCAL_1, SC_LOCAL_2
#define SC_DECLARE_TEXELS SC_TEXEL SC_LOCAL_1; SC_TEXEL SC_LOCAL_2
#define SC_OUT_TEXELS out SC_TEXEL texel, out SC_TEXEL texel_2
#define SC_STORE_AGAIN sc_store = sc_texel(); sc_store_2 = sc_texel_2()
#else
#define SC_TEXELS SC_LOCAL_1
#define SC_DECLARE_TEXELS SC_TEXEL SC_LOCAL_1
#define SC_OUT_TEXELS out SC_TEXEL texel
#define SC_STORE_AGAIN sc_store = sc_texel()
#endif

// What is computed anew is guarded; what was reused has been, and filters keep to its range. Only
// passes that compute are drawn after a reset.
#define SC_GUARDS (SC_GUARD_MISS || SC_GUARD_CLAMP && !SC_BITS)
#if SC_GUARDS
#define SC_STORE SC_AGING SC_STORE_AGAIN; sc_guard()
#define SC_STORE_UNLESS(reused) SC_AGING SC_STORE_AGAIN; if (!reused) { sc_guard(); }
#else
#define SC_STORE SC_AGING SC_STORE_AGAIN
#define SC_STORE_UNLESS(reused) SC_STORE;
#endif

// What the previous frame stored. What a guard is to bring into the range of the cache is brought
// there now: the third of three passes has shown it as it was computed.
#if SC_GUARD_CLAMP && SC_BITS
#define SC_READ(cache, place, discrete) sc_in_range(texelFetch(cache, place, 0), discrete)
#elif SC_GUARD_CLAMP
#define SC_READ(cache, place, discrete) sc_in_range(texelFetch(cache, place, 0))
#else
#define SC_READ(cache, place, discrete) texelFetch(cache, place, 0)
#endif

#if SC_TARGETS == 2
#define SC_IN_OUT_SUMS inout vec4 sum, inout vec4 sum_2 SC_OWN
#define SC_SUMS sum, sum_2 SC_THE_OWN
#define SC_DECLARE_SUMS vec4 sum = vec4(0.0); vec4 sum_2 = vec4(0.0) SC_DECLARE_OWN
#else
#define SC_IN_OUT_SUMS inout vec4 sum SC_OWN
#define SC_SUMS sum SC_THE_OWN
#define SC_DECLARE_SUMS vec4 sum = vec4(0.0) SC_DECLARE_OWN
#endif
