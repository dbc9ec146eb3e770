#version 330
// shadercache: 1-pass, node main.1-185b7c6a

uniform int sc_clock;
uniform int sc_period;
uniform int sc_block;
uniform sampler2D sc_cache;
vec4 sc_current;
uniform float sc_epsilon;
float sc_payload;
bool sc_moved = false;
layout(location = 1) out vec4 sc_store;
uniform float sc_limit;
uniform float sc_least;

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

uint sc_hash(uint x) {
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    x *= 0x9E3779B9u;
    return x ^ x >> 15;
}

int sc_residue(uint hashed) {
    return int((hashed >> 16) * uint(sc_period) >> 16);
}

int sc_swap(int slot, int partner, uint key) {
    int other = partner - slot;
    other += other < 0 ? sc_period : 0;
    return ((key + uint(max(slot, other))) * 0x9E3779B9u & 0x80000000u) == 0u ? slot : other;
}

int sc_turn() {
    float shrink = 1.0 / float(sc_block);
    vec2 block = floor(gl_FragCoord.xy * shrink);
    float across = ceil((float(textureSize(sc_cache, 0).x) - 0.5) * shrink);
    float number = block.y * across + block.x;
    float group = floor((number + 0.5) / float(sc_period));
    uint key = sc_hash(uint(group) * 9277u + 26699u);
    int turn = int(number - group * float(sc_period)) + sc_residue(key * 0xC2B2AE35u);
    turn -= turn >= sc_period ? sc_period : 0;
    turn = sc_swap(turn, sc_residue(key), key);
    return sc_swap(turn, sc_residue(key << 16), key ^ 0x85EBCA6Bu);
}

bool sc_due() {
    int phase = sc_turn() + sc_clock;
    return phase == 0 || phase == sc_period;
}

vec4 sc_chosen(vec4 a, vec4 b, vec4 c, vec4 d, vec4 weights) {
    vec4 sum = weights.x > 0.0 ? weights.x * a : vec4(0.0);
    sum += weights.y > 0.0 ? weights.y * b : vec4(0.0);
    sum += weights.z > 0.0 ? weights.z * c : vec4(0.0);
    return sum + (weights.w > 0.0 ? weights.w * d : vec4(0.0));
}

int sc_look_up(out vec4 texel) {
    ivec2 last = textureSize(sc_cache, 0) - 1;
    sc_current = scCurrentClip();
    vec4 sc_previous = scPreviousClip();
    vec2 motion = sc_previous.xy / sc_previous.w - sc_current.xy / sc_current.w;
    vec2 corner = gl_FragCoord.xy - 0.5 + 0.5 * vec2(last + 1) * motion;
    vec2 slope = vec2(dFdx(16.0 / sc_previous.w), dFdy(16.0 / sc_previous.w)) / (16.0 / sc_previous.w);
    vec2 whole = floor(corner);
    vec2 part = corner - whole;
    ivec2 near = clamp(ivec2(whole), ivec2(0), last);
    ivec2 far = min(near + ivec2(ceil(part)), last);
    vec4 a = texelFetch(sc_cache, near, 0);
    vec4 b = texelFetch(sc_cache, ivec2(far.x, near.y), 0);
    vec4 c = texelFetch(sc_cache, ivec2(near.x, far.y), 0);
    vec4 d = texelFetch(sc_cache, far, 0);
    texel = mix(mix(a, b, part.x), mix(c, d, part.x), part.y);
    if (sc_due()) {
        return 2;
    }
    if (!(sc_previous.w > 0.0 && all(greaterThanEqual(corner, vec2(0.0))) && all(lessThanEqual(corner, vec2(last))))) {
        return 3;
    }
    vec4 aside = 0.0625 * sc_previous.w * abs(vec4(a.w, b.w, c.w, d.w)) - 1.0 - slope.x * vec4(-part.x, 1.0 - part.x, -part.x, 1.0 - part.x) - slope.y * vec4(-part.y, -part.y, 1.0 - part.y, 1.0 - part.y);
    bvec4 moved = lessThan(vec4(a.w, b.w, c.w, d.w), vec4(0.0));
    vec4 single = vec4(lessThanEqual(abs(aside), vec4(sc_epsilon))) * vec4(not(moved));
    vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.y, 1.0 - part.y, part.y, part.y);
    float blended = dot(weights, abs(vec4(a.w, b.w, c.w, d.w)));
    bool one_surface = all(lessThanEqual(abs(0.0625 * sc_previous.w * abs(vec4(a.w, b.w, c.w, d.w)) - 1.0), vec4(24.0 * sc_epsilon)));
    bool agrees = one_surface && abs(0.0625 * sc_previous.w * blended - 1.0) <= sc_epsilon;
    if (one_surface && !agrees) {
        return 4;
    }
    bool marked = dot(weights, vec4(moved)) > 0.0;
    if (!agrees) {
        weights *= single;
        float total = dot(weights, vec4(1.0));
        if (!(total >= 0.25)) {
            return a.w == -65504.0 || b.w == -65504.0 || c.w == -65504.0 || d.w == -65504.0 ? 6 : 4;
        }
        weights /= total;
        texel = sc_chosen(a, b, c, d, weights);
        marked = true;
    }
    sc_moved = marked;
    return 1;
}

vec4 sc_texel() {
    return vec4(sc_payload, 0.0, 0.0, sc_moved ? -(16.0 / sc_current.w) : 16.0 / sc_current.w);
}

vec4 sc_held(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    vec4 held = mix(clamp(values, vec4(-sc_limit), vec4(sc_limit)), values, greaterThanEqual(sizes, uvec4(0x7F800000u)));
    return mix(values, held, greaterThan(sizes, uvec4(floatBitsToUint(sc_limit))));
}

void sc_hold() {
    if (sc_limit <= 65504.0) {
        sc_store = sc_held(sc_store);
    }
}

bool sc_unfit(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    return any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit)))) || any(lessThan(sizes - 1u, uvec4(least)));
}

void sc_guard() {
    bool unfit = sc_unfit(sc_store);
    if (unfit) {
        sc_hold();
        sc_store.w = -65504.0;
    }
}

void main() {
    vec4 texel;
    bool sc_hit = sc_look_up(texel) == 1;
    if (sc_hit) {
        sc_payload = texel.x;
    } else {
        sc_compute();
    }
    sc_shade();
    sc_store = sc_texel();
    if (!sc_hit) {
        sc_guard();
    }
}
