#version 330
// shadercache: 1-pass, node main.1-185b7c6a

// What a look-up says. All but a hit are misses; the hit mask shows which.
const int sc_hit = 1;
const int sc_refresh = 2; // computed anew on purpose
const int sc_miss_outside = 3; // was not in the picture
const int sc_miss_depth = 4; // another surface was seen there
const int sc_miss_poison = 6; // what was stored must not be reused
const float sc_poison_depth = -65504.0; // depth of what must not be reused
uniform int sc_clock; // frames, already reduced to [0, sc_period)
uniform int sc_period; // frames from one refresh of a pixel to the next
uniform int sc_block; // edge, even, of the squares of pixels that take turns: on 2x2 quads
uniform sampler2D sc_cache; // what the previous frame stored: payload and depth
uniform float sc_epsilon; // greatest accepted difference of depths, relative to the depth
uniform float sc_limit; // the largest value that is reused
uniform float sc_least; // the smallest one above zero that it surely holds
layout(location = 1) out vec4 sc_store; // what the next frame finds in the cache
bool sc_moved = false; // is the payload not just that of this place?
vec4 sc_current; // clip-space position in this frame
float sc_payload;

// A ball on a floor; the camera travels round it. What the pixel shows is found by marching, and
// where the last frame showed it follows from where the camera was then.
uniform vec2 u_resolution;
uniform float u_time;
uniform float u_time_delta;
layout(location = 0) out vec4 o_color;
const float ZOOM = 1.6;
const float FAR = 12.0;

struct Camera {
    vec3 eye;
    mat3 axes;
};

Camera camera(float time) {
    vec3 eye = vec3(4.0 * sin(0.6 * time), 1.8, 4.0 * cos(0.6 * time));
    vec3 back = normalize(eye - vec3(0.0, 0.6, 0.0));
    vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), back));
    return Camera(eye, mat3(right, cross(back, right), back));
}

vec3 ray(Camera from) {
    vec2 at = (2.0 * gl_FragCoord.xy - u_resolution) / u_resolution.y;
    return from.axes * normalize(vec3(at, -ZOOM));
}

float away(vec3 p) {
    return min(length(p - vec3(0.0, 1.0, 0.0)) - 1.0, p.y);
}

float march(vec3 eye, vec3 along) {
    float way = 0.0;
    for (int i = 0; i < 48; i++) {
        float left = away(eye + way * along);
        if (left < 1e-4 * way || way > FAR) {
            break;
        }
        way += left;
    }
    return min(way, FAR);
}

vec3 shown() {
    Camera now = camera(u_time);
    vec3 along = ray(now);
    return now.eye + march(now.eye, along) * along;
}

vec4 clip(vec3 p, Camera by) {
    vec3 seen = (p - by.eye) * by.axes;
    return vec4(ZOOM * u_resolution.y / u_resolution.x * seen.x, ZOOM * seen.y, 0.0, -seen.z);
}

vec4 scPreviousClip() {
    return clip(shown(), camera(u_time - u_time_delta));
}

vec4 scCurrentClip() {
    return clip(shown(), camera(u_time));
}

float marble(vec3 p) {
    return sin(7.0 * p.x + 3.0 * sin(5.0 * p.y)) * cos(6.0 * p.z + 2.0 * sin(4.0 * p.x));
}

void sc_compute() {
    vec3 p = shown();
    sc_payload = marble(p) + 0.5 * marble(2.1 * p.zxy);
}

void sc_shade() {
    vec3 p = shown();
    float stone = sc_payload;
    vec3 up = normalize(vec3(away(p + vec3(1e-2, 0.0, 0.0)), away(p + vec3(0.0, 1e-2, 0.0)), 0.02));
    o_color = vec4(vec3(0.5 + 0.2 * stone) * (0.6 + 0.4 * up.y), 1.0);
}

// A well mixed 32-bit hash.
uint sc_hash(uint x) {
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    x *= 0x9E3779B9u;
    return x ^ x >> 15;
}

// A hash made uniform in [0, sc_period).
int sc_residue(uint hashed) {
    return int((hashed >> 16) * uint(sc_period) >> 16);
}

// One round of a shuffle of [0, sc_period) by swaps, each made or not (Hoang, Morris and Rogaway
// 2012): for any period, without a table.
int sc_swap(int slot, int partner, uint key) {
    int other = partner - slot;
    other += other < 0 ? sc_period : 0;
    return ((key + uint(max(slot, other))) * 0x9E3779B9u & 0x80000000u) == 0u ? slot : other;
}

// The frame of each period in which the pixel's turn comes.
int sc_turn() {
    // Blocks are numbered row by row, which is less to compute than groups as high as wide, and as
    // floats: exact below 2^23 blocks, and above them a pixel still has one turn in each period.
    float shrink = 1.0 / float(sc_block);
    vec2 block = floor(gl_FragCoord.xy * shrink);
    float across = ceil((float(textureSize(sc_cache, 0).x) - 0.5) * shrink);
    float number = block.y * across + block.x;
    float group = floor((number + 0.5) / float(sc_period));
    uint key = sc_hash(uint(group) * 9277u + 26699u);
    // Turned by a number of the group's own as well: one swap in four is none, and the places that
    // keep their turn must not stand one above the other.
    int turn = int(number - group * float(sc_period)) + sc_residue(key * 0xC2B2AE35u);
    turn -= turn >= sc_period ? sc_period : 0;
    turn = sc_swap(turn, sc_residue(key), key);
    return sc_swap(turn, sc_residue(key << 16), key ^ 0x85EBCA6Bu);
}

// (turn + clock) mod period == 0: no remainder is taken, since both are in [0, period).
bool sc_due() {
    int phase = sc_turn() + sc_clock;
    return phase == 0 || phase == sc_period;
}

// Four texels by their weights, those without one left out: they may hold NaN, and 0 times NaN is
// NaN. What is added for those is -0, as 0 would make 0 of -0.
vec4 sc_chosen(vec4 a, vec4 b, vec4 c, vec4 d, vec4 weights) {
    vec4 sum = weights.x > 0.0 ? weights.x * a : vec4(-0.0);
    sum += weights.y > 0.0 ? weights.y * b : vec4(-0.0);
    sum += weights.z > 0.0 ? weights.z * c : vec4(-0.0);
    return sum + (weights.w > 0.0 ? weights.w * d : vec4(-0.0));
}

// Where the previous frame holds what the pixel shows, whether that may be reused, and what it is.
int sc_look_up(out vec4 sc_texel) {
    ivec2 last = textureSize(sc_cache, 0) - 1;
    sc_current = scCurrentClip();
    vec4 sc_previous = scPreviousClip();
    vec2 motion = sc_previous.xy / sc_previous.w - sc_current.xy / sc_current.w;
    // Counted in texels from the middle of the first one: its whole part is the lower left of the
    // four texels around the place.
    vec2 place = gl_FragCoord.xy - 0.5 + 0.5 * vec2(last + 1) * motion;
    // How place and expected depth change from pixel to pixel. Ahead of every exit, as derivatives
    // must be.
    vec2 slope = vec2(dFdx(16.0 / sc_previous.w), dFdy(16.0 / sc_previous.w)) / (16.0 / sc_previous.w);
    // At rest the motion is exactly zero: all four are the pixel's own texel, nothing is filtered.
    vec2 whole = floor(place);
    vec2 part = place - whole;
    ivec2 near = clamp(ivec2(whole), ivec2(0), last);
    ivec2 far = min(near + ivec2(ceil(part)), last);
    vec4 a = textureLod(sc_cache, (vec2(near) + 0.5) / vec2(textureSize(sc_cache, 0)), 0.0);
    vec4 b = textureLod(sc_cache, (vec2(ivec2(far.x, near.y)) + 0.5) / vec2(textureSize(sc_cache, 0)), 0.0);
    vec4 c = textureLod(sc_cache, (vec2(ivec2(near.x, far.y)) + 0.5) / vec2(textureSize(sc_cache, 0)), 0.0);
    vec4 d = textureLod(sc_cache, (vec2(far) + 0.5) / vec2(textureSize(sc_cache, 0)), 0.0);
    sc_texel = mix(mix(a, b, part.x), mix(c, d, part.x), part.y);
    if (sc_due()) {
        return sc_refresh;
    }
    // All four texels lie in the cache; a point behind the camera was not seen.
    if (!(sc_previous.w > 0.0 && all(greaterThanEqual(place, vec2(0.0))) && all(lessThanEqual(place, vec2(last))))) {
        return sc_miss_outside;
    }
    vec4 kept = vec4(a.w, b.w, c.w, d.w);
    vec4 depths = abs(kept);
    bvec4 moved = lessThan(kept, vec4(0.0));
    // Which texels fit by themselves, where the surface slopes on as it does at the pixel?
    vec4 aside = 0.0625 * sc_previous.w * depths - 1.0 - slope.x * vec4(-part.x, 1.0 - part.x, -part.x, 1.0 - part.x) - slope.y * vec4(-part.y, -part.y, 1.0 - part.y, 1.0 - part.y);
    vec4 fits = vec4(lessThanEqual(abs(aside), vec4(sc_epsilon))) * vec4(not(moved));
    // Do all four together show one surface, and is it the pixel's?
    vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.y, 1.0 - part.y, part.y, part.y);
    float blended = dot(weights, depths);
    bool one_surface = all(lessThanEqual(abs(0.0625 * sc_previous.w * depths - 1.0), vec4(24.0 * sc_epsilon)));
    bool agrees = one_surface && abs(0.0625 * sc_previous.w * blended - 1.0) <= sc_epsilon;
    // A fold: one of its sides must not be taken for the other.
    if (one_surface && !agrees) {
        return sc_miss_depth;
    }
    bool marked = dot(weights, vec4(moved)) > 0.0;
    if (!agrees) {
        weights *= fits;
        float total = dot(weights, vec4(1.0));
        if (!(total >= 0.25)) {
            return a.w == sc_poison_depth || b.w == sc_poison_depth || c.w == sc_poison_depth || d.w == sc_poison_depth ? sc_miss_poison : sc_miss_depth;
        }
        weights /= total;
        sc_texel = sc_chosen(a, b, c, d, weights);
        marked = true;
    }
    sc_moved = marked;
    return sc_hit;
}

// What is stored of the payloads.
vec4 sc_pack() {
    return vec4(sc_payload, 0.0, 0.0, sc_moved ? -(16.0 / sc_current.w) : 16.0 / sc_current.w);
}

// Can the cache not hold a value? The bits are compared: they are in the order of the sizes, NaN lies
// above infinity, and no driver can make less of them than they are.
bool sc_unfit(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    return any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit)))) || any(lessThan(sizes - 1u, uvec4(least)));
}

// Numbers as near as half floats can hold them. Infinity and NaN stay.
vec4 sc_held(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    vec4 held = mix(clamp(values, vec4(-sc_limit), vec4(sc_limit)), values, greaterThanEqual(sizes, uvec4(0x7F800000u)));
    return mix(values, held, greaterThan(sizes, uvec4(floatBitsToUint(sc_limit))));
}

// A cache of half floats is written what it can hold.
void sc_hold() {
    if (sc_limit <= 65504.0) {
        sc_store = sc_held(sc_store);
    }
}

// Marks a texel that must not be reused. The third of three passes reads it in this frame, so it
// holds what was computed, or what comes nearest of larger numbers.
void sc_guard() {
    bool unfit = sc_unfit(sc_store);
    if (unfit) {
        sc_hold();
        sc_store.w = sc_poison_depth;
    }
}

// One pass: reuse the payload or compute it, then shade.
void main() {
    vec4 sc_texel;
    bool sc_reused = sc_look_up(sc_texel) == sc_hit;
    if (sc_reused) {
        sc_payload = sc_texel.x;
    } else {
        sc_compute();
    }
    sc_shade();
    sc_store = sc_pack();
    if (!sc_reused) {
        sc_guard();
    }
}
