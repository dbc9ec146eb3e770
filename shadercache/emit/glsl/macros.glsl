// Words that the other files use. Set before, by emit/layout.py: SC_TARGETS (1 or 2 textures),
// SC_BITS (do they hold unsigned integers?), SC_WHOLE (may there be no payload?), SC_MASKED (and are
// there several?), SC_DECLARE_PAYLOADS (their variables), SC_PACKED_1 and SC_PACKED_2 (their channels
// in each texel, without the depth), SC_UNPACK (the assignments to them from the texels),
// SC_CHANNELS (the texel's channels that are the payload, where it is one scalar or vector of floats
// in one texel), SC_DECLARE_VALID, SC_SET_VALID and SC_VALID (whether there is a payload, for each of
// them; are there all?), SC_DISCRETE_1 and SC_DISCRETE_2 (masks of the channels that hold integers or
// booleans), SC_ANY_DISCRETE_1 and SC_ANY_DISCRETE_2 (are there any?), SC_LOCAL_1 and
// SC_LOCAL_2 (names of main's variables: two texels); set by emit/runtime.py: SC_SURFACE, SC_SCREEN
// and SC_USER (one of them is 1: the mapping), SC_OWN_CURRENT (does the user say where the pixel is?).

// Is the pixel's own place the clip-space position in this frame?
#define SC_PIXEL_IS_CURRENT (SC_SCREEN || SC_USER && !SC_OWN_CURRENT)

#if SC_PIXEL_IS_CURRENT
#define SC_DEPTH_OF_PIXEL gl_FragCoord.w
#else
#define SC_DEPTH_OF_PIXEL 1.0 / sc_current.w
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
#define SC_FLOAT(channel) uintBitsToFloat(channel)
#define SC_INVERSE_W floatBitsToUint(SC_DEPTH_OF_PIXEL)
#define SC_NO_DEPTH 0u
#define SC_EMPTY uvec4(0u)
#else
#define SC_TEXEL vec4
#define SC_SAMPLER sampler2D
#define SC_FLOAT(channel) channel
#define SC_INVERSE_W SC_DEPTH_OF_PIXEL
#define SC_NO_DEPTH -1.0
#define SC_EMPTY vec4(0.0, 0.0, 0.0, -1.0)
#endif

// SC_STORE stores; SC_CARRY is for passes that compute nothing, so are not drawn after a reset.
#if SC_AGE
#define SC_AGING sc_stagger();
#else
#define SC_AGING
#endif

#if SC_TARGETS == 2
#define SC_TEXELS SC_LOCAL_1, SC_LOCAL_2
#define SC_DECLARE_TEXELS SC_TEXEL SC_LOCAL_1; SC_TEXEL SC_LOCAL_2
#define SC_OUT_TEXELS out SC_TEXEL texel, out SC_TEXEL texel_2
#define SC_STORE SC_AGING SC_CARRY
#define SC_CARRY sc_store = sc_texel(); sc_store_2 = sc_texel_2()
#else
#define SC_TEXELS SC_LOCAL_1
#define SC_DECLARE_TEXELS SC_TEXEL SC_LOCAL_1
#define SC_OUT_TEXELS out SC_TEXEL texel
#define SC_STORE SC_AGING SC_CARRY
#define SC_CARRY sc_store = sc_texel()
#endif
