// Words that the other files use. Set before, by emit/layout.py: SC_TARGETS (1 or 2 textures),
// SC_BITS (do they hold unsigned integers?), SC_WHOLE (may there be no payload?), PAYLOAD (its type), PACKED_1 and PACKED_2 (its channels
// in each texel, without the depth), UNPACKED (the payload from the texels), CHANNELS (the texel's
// channels that are the payload, where it is a scalar or vector of floats in one texel), DISCRETE_1
// and DISCRETE_2 (masks of the channels that hold integers or booleans; SC_DISCRETE_1, SC_DISCRETE_2:
// are there any?).

#if SC_BITS
#define TEXEL uvec4
#define SAMPLER usampler2D
#define FLOAT(channel) uintBitsToFloat(channel)
#define DEPTH floatBitsToUint(1.0 / sc_current.w)
#define EMPTY uvec4(0u)
#else
#define TEXEL vec4
#define SAMPLER sampler2D
#define FLOAT(channel) channel
#define DEPTH 1.0 / sc_current.w
#define EMPTY vec4(0.0, 0.0, 0.0, -1.0)
#endif

#if SC_TARGETS == 2
#define TEXELS texel, texel_2
#define DECLARE_TEXELS TEXEL texel; TEXEL texel_2
#define OUT_TEXELS out TEXEL texel, out TEXEL texel_2
#define STORE sc_store = sc_texel(); sc_store_2 = sc_texel_2()
#else
#define TEXELS texel
#define DECLARE_TEXELS TEXEL texel
#define OUT_TEXELS out TEXEL texel
#define STORE sc_store = sc_texel()
#endif
