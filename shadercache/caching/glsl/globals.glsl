// What the programs declare, as far as they need it. Names in capitals: see caching/fill.py.

uniform int sc_clock;            // frames, already reduced to [0, sc_period)
uniform int sc_period;           // frames from one refresh of a pixel to the next
uniform int sc_block;            // edge, even, of the squares of pixels that take turns: on 2x2 quads
uniform sc_SAMPLERS sc_cache;    // what the previous frame stored: payload and depth
uniform float sc_epsilon;        // greatest accepted difference of depths, relative to the depth
uniform float sc_resolution;     // what stored depths are rounded by, relative to them
uniform float sc_unit;           // 2 near far / (far - near), what 1/w is in depths from -1 to 1
uniform float sc_magnification;  // how many times larger a surface may have become
uniform int sc_mask;             // 1: the draw reuses nothing; 2: and nobody reuses it
uniform ivec4 sc_viewport;       // left, bottom, width and height of what is drawn into, in pixels
uniform ivec4 sc_previous_viewport;  // the same of the previous frame
uniform vec4 sc_scale;           // from pixels to texels of a smaller cache: times .xy, plus .zw
uniform float sc_limit;          // the largest value that is reused
uniform float sc_least;          // the smallest one above zero that it surely holds
uniform float sc_change;         // how much a refresh may change a payload and leave the period as it is
uniform int sc_reset;            // 1 in a frame that follows a reset, else 0
uniform int sc_group;            // from 1: number of the draw, or of those with the same uniforms
uniform sc_SAMPLERS sc_payloads;  // what this frame has stored so far

out sc_TEXELS sc_store;  // what the next frame finds in the cache

bool sc_reuse = false;  // are the payloads those of the cache?
bool sc_lacks = false;  // was a payload needed, and none there?
bool sc_moved = false;  // is the payload not just that of this place?
float sc_age = 0.0;     // frames since the payload was computed
float sc_halvings = -1.0;  // how often its period is halved; below 0 nobody knows yet

// What a look-up says. All but a hit are misses; the hit mask shows which.
const int sc_hit = 1;
const int sc_refresh = 2;         // computed anew on purpose
const int sc_miss_outside = 3;    // was not in the picture
const int sc_miss_depth = 4;      // another surface was seen there
const int sc_miss_id = 5;         // another object was seen there
const int sc_miss_poison = 6;     // what was stored must not be reused
const int sc_miss_magnified = 7;  // has become much larger
const int sc_opted_out = 8;       // the draw reuses nothing
const int sc_miss_old = 9;        // is too old by now
