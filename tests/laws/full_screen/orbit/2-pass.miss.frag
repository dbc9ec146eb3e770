#version 330
// shadercache: 2-pass.miss, node main.1-185b7c6a

const float sc_poison_depth = -65504.0; // depth of what must not be reused
uniform float sc_limit; // the largest value that is reused
uniform float sc_least; // the smallest one above zero that it surely holds
layout(location = 1) out vec4 sc_store; // what the next frame finds in the cache
vec4 sc_current; // clip-space position in this frame
float sc_payload;

// A ball on a floor; the camera travels round it. What the pixel shows is found by marching, and
// where the last frame showed it follows from where the camera was then.
uniform vec2 u_resolution;
uniform float u_time;
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

vec4 scCurrentClip() {
    return clip(shown(), camera(u_time));
}

float marble(vec3 p) {
    return sin(7.0 * p.x + 3.0 * sin(5.0 * p.y)) * cos(6.0 * p.z + 2.0 * sin(4.0 * p.x));
}

void sc_shade() {
    vec3 p = shown();
    sc_payload = marble(p) + 0.5 * marble(2.1 * p.zxy);
    float stone = sc_payload;
    vec3 up = normalize(vec3(away(p + vec3(1e-2, 0.0, 0.0)), away(p + vec3(0.0, 1e-2, 0.0)), 0.02));
    o_color = vec4(vec3(0.5 + 0.2 * stone) * (0.6 + 0.4 * up.y), 1.0);
}

// What is stored of the payloads.
vec4 sc_pack() {
    return vec4(sc_payload, 0.0, 0.0, 16.0 / sc_current.w);
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

// Two passes, second: the whole shader, for the pixels that the first pass left open.
void main() {
    sc_current = scCurrentClip();
    sc_shade();
    sc_store = sc_pack();
    sc_guard();
}
