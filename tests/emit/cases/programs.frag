#version 330
uniform sampler2D u_map;
uniform vec3 u_tint;
uniform float u_time;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

//// The payload's pass has no lighting, and the shading pass no payload.
//// node: noise(p) + 0.5 * noise(p * 2.0)
//// guard: off
//// shows: 3-pass.payload.frag
//// shows: 3-pass.shade.frag
float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}
vec3 stone(vec3 p) {
    float octaves = noise(p) + 0.5 * noise(p * 2.0) + 0.25 * noise(p * 4.0);
    vec4 grain = texture(u_map, p.xy);
    return mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
}
void main() {
    vec3 normal = normalize(v_normal);
    vec3 albedo = stone(v_position);
    float light = max(dot(normal, u_tint), 0.0);
    o_color = vec4(albedo * light + texture(u_map, v_uv).rgb, 1.0);
}
//// becomes
#version 330
// shadercache: 3-pass.payload, node stone.1-ae098caa

in vec4 sc_current; // clip-space position in this frame
layout(location = 0) out vec4 sc_store; // what the next frame finds in the cache
float sc_payload;
in vec3 v_position;

float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}

void sc_stone(vec3 p) {
    sc_payload = noise(p) + 0.5 * noise(p * 2.0);
}

void sc_compute() {
    sc_stone(v_position);
}

// What is stored of the payloads.
vec4 sc_pack() {
    return vec4(sc_payload, 0.0, 0.0, 16.0 / sc_current.w);
}

// Three passes, second: the payload alone, for the pixels that the first pass left open.
void main() {
    sc_compute();
    sc_store = sc_pack();
}

#version 330
// shadercache: 3-pass.shade, node stone.1-ae098caa

uniform sampler2D sc_payloads; // what this frame has stored so far
float sc_payload;
uniform sampler2D u_map;
uniform vec3 u_tint;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
layout(location = 0) out vec4 o_color;

float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}

vec3 sc_stone(vec3 p) {
    float octaves = sc_payload + 0.25 * noise(p * 4.0);
    vec4 grain = texture(u_map, p.xy);
    return mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
}

void sc_shade() {
    vec3 normal = normalize(v_normal);
    vec3 albedo = sc_stone(v_position);
    float light = max(dot(normal, u_tint), 0.0);
    o_color = vec4(albedo * light + texture(u_map, v_uv).rgb, 1.0);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    sc_payload = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0).x;
    sc_shade();
}

//// Other calls of a function are not disturbed.
//// node: sin(p.x * 12.9) * sin(p.y * 78.2)
//// path: noise@2
//// shows: 3-pass.shade.frag
float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}
vec3 stone(vec3 p) {
    float octaves = noise(p) + 0.5 * noise(p * 2.0) + 0.25 * noise(p * 4.0);
    vec4 grain = texture(u_map, p.xy);
    return mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
}
void main() {
    vec3 normal = normalize(v_normal);
    vec3 albedo = stone(v_position);
    float light = max(dot(normal, u_tint), 0.0);
    o_color = vec4(albedo * light + texture(u_map, v_uv).rgb, 1.0);
}
//// becomes
#version 330
// shadercache: 3-pass.shade, node noise.1-9a85b2d5

uniform sampler2D sc_payloads; // what this frame has stored so far
float sc_payload;
uniform sampler2D u_map;
uniform vec3 u_tint;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
layout(location = 0) out vec4 o_color;

float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}

float sc_noise(vec3 p) {
    return sc_payload * sin(p.z * 37.7);
}

vec3 sc_stone(vec3 p) {
    float octaves = noise(p) + 0.5 * sc_noise(p * 2.0) + 0.25 * noise(p * 4.0);
    vec4 grain = texture(u_map, p.xy);
    return mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
}

void sc_shade() {
    vec3 normal = normalize(v_normal);
    vec3 albedo = sc_stone(v_position);
    float light = max(dot(normal, u_tint), 0.0);
    o_color = vec4(albedo * light + texture(u_map, v_uv).rgb, 1.0);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    sc_payload = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0).x;
    sc_shade();
}

//// One pass fetches ahead of its branch.
//// node: albedo
//// shows: 1-pass.frag main sc_fetch_ahead sc_fetch_0_ahead sc_stone
float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}
vec3 stone(vec3 p) {
    float octaves = noise(p) + 0.5 * noise(p * 2.0) + 0.25 * noise(p * 4.0);
    vec4 grain = texture(u_map, p.xy);
    return mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
}
void main() {
    vec3 normal = normalize(v_normal);
    vec3 albedo = stone(v_position);
    float light = max(dot(normal, u_tint), 0.0);
    o_color = vec4(albedo * light + texture(u_map, v_uv).rgb, 1.0);
}
//// becomes
void sc_stone(vec3 p) {
    sc_fetch_0 = texture(u_map, p.xy);
}
void sc_fetch_0_ahead() {
    sc_stone(v_position);
}
void sc_fetch_ahead() {
    sc_fetch_0_ahead();
}
void main() {
    sc_fetch_ahead();
    vec4 sc_texel;
    bool sc_reused = sc_look_up(sc_texel) == sc_hit;
    if (sc_reused) {
        sc_payload = sc_texel.xyz;
    } else {
        sc_compute();
    }
    sc_shade();
    sc_store = sc_pack();
    if (!sc_reused) {
        sc_guard();
    }
}

//// Names of the user that look like ours.
//// node: noise(v_position)
//// shows: 2-pass.hit.frag main sc1_shade sc_look_up
float sc_look_up(float x) {
    return x;
}
float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}
vec3 stone(vec3 p) {
    float octaves = noise(p) + 0.5 * noise(p * 2.0) + 0.25 * noise(p * 4.0);
    vec4 grain = texture(u_map, p.xy);
    return mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
}
void main() {
    float sc_payload = noise(v_position);
    o_color = vec4(sc_look_up(sc_payload));
}
//// becomes
float sc_look_up(float x) {
    return x;
}
void sc1_shade() {
    float sc_payload = sc1_payload;
    o_color = vec4(sc_look_up(sc_payload));
}
void main() {
    vec4 sc1_texel;
    if (sc1_look_up(sc1_texel) != sc1_hit) {
        discard;
    }
    sc1_payload = sc1_texel.x;
    sc1_shade();
    sc1_store = sc1_pack();
}

//// One pass computes the payload without changing the globals.
//// node: p
//// shows: 1-pass.frag main sc_compute sc_compute_only sc_shade
float height = 1.0;
void raise(float x) {
    height = x;
}
void main() {
    float before = height * u_time;
    raise(v_uv.x);
    vec3 p = sin(v_position);
    o_color = vec4(p * before, height);
}
//// becomes
void sc_compute_only() {
    vec3 p = sin(v_position);
    sc_payload = p;
}
void sc_shade() {
    float before = height * u_time;
    raise(v_uv.x);
    o_color = vec4(sc_payload * before, height);
}
void sc_compute() {
    float sc_kept_1 = height;
    sc_compute_only();
    height = sc_kept_1;
}
void main() {
    vec4 sc_texel;
    bool sc_reused = sc_look_up(sc_texel) == sc_hit;
    if (sc_reused) {
        sc_payload = sc_texel.xyz;
    } else {
        sc_compute();
    }
    sc_shade();
    sc_store = sc_pack();
    if (!sc_reused) {
        sc_guard();
    }
}

//// What the type of the payload needs stands before the variable.
//// node: make(v_position)
//// shows: 3-pass.shade.frag
const int COUNT = 2;
struct Many {
    float values[COUNT];
};
Many make(vec3 p) {
    Many m;
    m.values[0] = sin(p.x);
    m.values[1] = sin(p.y);
    return m;
}
void main() {
    Many m = make(v_position);
    o_color = vec4(m.values[0], m.values[1], 0.0, 1.0);
}
//// becomes
#version 330
// shadercache: 3-pass.shade, node main.0-fe912872

uniform sampler2D sc_payloads; // what this frame has stored so far
layout(location = 0) out vec4 o_color;
const int COUNT = 2;

struct Many {
    float values[COUNT];
};

Many sc_payload;

void sc_shade() {
    Many m = sc_payload;
    o_color = vec4(m.values[0], m.values[1], 0.0, 1.0);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    vec4 sc_texel = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0);
    sc_payload = Many(float[2](sc_texel.x, sc_texel.y));
    sc_shade();
}

//// Names of structs and fields that look like ours; the variant with most locals.
//// node: make(v_position)
//// shows: 2-pass.hit.frag main sc1_unpack sc1_shade
struct texel {
    float DEPTH;
};
struct outcome {
    texel t;
    float sc_TEXEL;
    int STORE;
};
outcome make(vec3 p) {
    return outcome(texel(sin(p.x)), sin(p.y), 1);
}
void main() {
    outcome m = make(v_position);
    o_color = vec4(m.t.DEPTH, m.sc_TEXEL, 0.0, 1.0) + texture(u_map, v_uv);
}
//// becomes
void sc1_shade() {
    outcome m = sc1_payload;
    o_color = vec4(m.t.DEPTH, m.sc_TEXEL, 0.0, 1.0) + texture(u_map, v_uv);
}
void main() {
    uvec4 sc1_texel;
    sc1_lacks = sc1_look_up(sc1_texel) != sc1_hit;
    sc1_payload = outcome(texel(uintBitsToFloat(sc1_texel.x)), uintBitsToFloat(sc1_texel.y), int(sc1_texel.z));
    sc1_shade();
    sc1_store = sc1_pack();
    if (sc1_lacks) {
        discard;
    }
}

//// Of a sum the part that is cut out goes, and the rest reads as it was written.
//// node: c += wave(v_position.z)
//// shows: 3-pass.payload.frag
//// shows: 3-pass.shade.frag
float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}
void main() {
    float c = wave(v_position.x);
    c += wave(v_position.y);
    c += wave(v_position.z);
    o_color = vec4(c, wave(v_position.x) + wave(v_position.y), 0.0, 1.0);
}
//// becomes
#version 330
// shadercache: 3-pass.payload, node main.8-7a4a5fd1

const float sc_poison_depth = -65504.0; // depth of what must not be reused
uniform float sc_limit; // the largest value that is reused
uniform float sc_least; // the smallest one above zero that it surely holds
in vec4 sc_current; // clip-space position in this frame
layout(location = 0) out vec4 sc_store; // what the next frame finds in the cache
float sc_payload;
in vec3 v_position;

float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}

void sc_compute() {
    float c = wave(v_position.x);
    c += wave(v_position.y);
    sc_payload = c + wave(v_position.z);
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

// Three passes, second: the payload alone, for the pixels that the first pass left open.
void main() {
    sc_compute();
    sc_store = sc_pack();
    sc_guard();
}

#version 330
// shadercache: 3-pass.shade, node main.8-7a4a5fd1

uniform sampler2D sc_payloads; // what this frame has stored so far
float sc_payload;
in vec3 v_position;
layout(location = 0) out vec4 o_color;

float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}

void sc_shade() {
    float c;
    c = sc_payload;
    o_color = vec4(c, wave(v_position.x) + wave(v_position.y), 0.0, 1.0);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    sc_payload = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0).x;
    sc_shade();
}
