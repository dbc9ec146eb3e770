#version 330
uniform sampler2D u_map;
uniform vec3 u_tint;
uniform float u_time;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

//// Stratified.
//// node: sin(v_position * 12.9) * sin(v_position.yzx * 78.2)
//// refresh: stratified
//// shows: 2-pass.hit.frag sc_swap sc_clock sc_period sc_block sc_number sc_reset sc_age sc_due sc_turn
void main() {
    vec3 albedo = sin(v_position * 12.9) * sin(v_position.yzx * 78.2);
    o_color = vec4(albedo * dot(normalize(v_normal), u_tint), 1.0);
}
//// becomes
uniform int sc_clock;
uniform int sc_period;
uniform int sc_block;
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

//// Random.
//// node: sin(v_position * 12.9) * sin(v_position.yzx * 78.2)
//// refresh: random
//// shows: 2-pass.hit.frag sc_swap sc_clock sc_period sc_block sc_number sc_reset sc_age sc_due sc_turn
void main() {
    vec3 albedo = sin(v_position * 12.9) * sin(v_position.yzx * 78.2);
    o_color = vec4(albedo * dot(normalize(v_normal), u_tint), 1.0);
}
//// becomes
uniform int sc_clock;
uniform int sc_period;
uniform int sc_block;
int sc_turn() {
    uvec2 block = uvec2(gl_FragCoord.xy / float(sc_block));
    return sc_residue(sc_hash(block.x * 1973u + block.y * 9277u + 26699u));
}
bool sc_due() {
    int phase = sc_turn() + sc_clock;
    return phase == 0 || phase == sc_period;
}

//// Tiled.
//// node: sin(v_position * 12.9) * sin(v_position.yzx * 78.2)
//// refresh: tiled
//// shows: 2-pass.hit.frag sc_swap sc_clock sc_period sc_block sc_number sc_reset sc_age sc_due sc_turn
void main() {
    vec3 albedo = sin(v_position * 12.9) * sin(v_position.yzx * 78.2);
    o_color = vec4(albedo * dot(normalize(v_normal), u_tint), 1.0);
}
//// becomes
uniform int sc_clock;
uniform int sc_period;
uniform int sc_block;
int sc_number(vec2 blocks, float tall) {
    vec2 block = floor(gl_FragCoord.xy / float(sc_block));
    float bottom = floor((block.y + 0.5) / tall) * tall;
    float column = min(tall, blocks.y - bottom);
    return int(bottom) * int(blocks.x) + int(block.x * column + block.y - bottom);
}
int sc_turn() {
    vec2 blocks = sc_blocks();
    float tile = ceil((blocks.x * blocks.y - 0.5) / float(sc_period));
    return int((float(sc_number(blocks, floor(sqrt(tile) + 0.01))) + 0.5) / tile);
}
bool sc_due() {
    int phase = sc_turn() + sc_clock;
    return phase == 0 || phase == sc_period;
}

//// By triangles.
//// node: sin(v_position * 12.9) * sin(v_position.yzx * 78.2)
//// refresh: surface
//// shows: 2-pass.hit.frag sc_swap sc_clock sc_period sc_block sc_number sc_reset sc_age sc_due sc_turn
void main() {
    vec3 albedo = sin(v_position * 12.9) * sin(v_position.yzx * 78.2);
    o_color = vec4(albedo * dot(normalize(v_normal), u_tint), 1.0);
}
//// becomes
uniform int sc_clock;
uniform int sc_period;
int sc_turn() {
    return sc_residue(sc_hash(uint(gl_PrimitiveID >> 6) * 9277u + 26699u));
}
bool sc_due() {
    int phase = sc_turn() + sc_clock;
    return phase == 0 || phase == sc_period;
}

//// None.
//// node: sin(v_position * 12.9) * sin(v_position.yzx * 78.2)
//// refresh: none
//// shows: 2-pass.hit.frag sc_swap sc_clock sc_period sc_block sc_number sc_reset sc_age sc_due sc_turn
void main() {
    vec3 albedo = sin(v_position * 12.9) * sin(v_position.yzx * 78.2);
    o_color = vec4(albedo * dot(normalize(v_normal), u_tint), 1.0);
}
//// becomes

//// None but by age.
//// node: sin(v_position * 12.9) * sin(v_position.yzx * 78.2)
//// refresh: none
//// age: on
//// shows: 2-pass.hit.frag sc_swap sc_clock sc_period sc_block sc_number sc_reset sc_age sc_due sc_turn
void main() {
    vec3 albedo = sin(v_position * 12.9) * sin(v_position.yzx * 78.2);
    o_color = vec4(albedo * dot(normalize(v_normal), u_tint), 1.0);
}
//// becomes
uniform int sc_period;
float sc_age = 0.0;

//// Ages lie behind the payload.
//// node: sin(v_position * 12.9) * sin(v_position.yzx * 78.2)
//// age: on
//// shows: 3-pass.payload.frag
//// shows: 3-pass.shade.frag
void main() {
    vec3 albedo = sin(v_position * 12.9) * sin(v_position.yzx * 78.2);
    o_color = vec4(albedo * dot(normalize(v_normal), u_tint), 1.0);
}
//// becomes
#version 330
// shadercache: 3-pass.payload, node main.0-ca91d057

const float sc_poison_depth = -65504.0; // depth of what must not be reused
uniform int sc_period; // frames from one refresh of a pixel to the next
uniform int sc_block; // edge, even, of the squares of pixels that take turns: on 2x2 quads
uniform float sc_limit; // the largest value that is reused
uniform float sc_least; // the smallest one above zero that it surely holds
uniform int sc_reset; // 1 in a frame that follows a reset, else 0
in vec4 sc_current; // clip-space position in this frame
layout(location = 0) out vec4 sc_store; // what the next frame finds in the cache
layout(location = 1) out vec4 sc_store_2;
float sc_age = 0.0; // frames since the payload was computed
vec3 sc_payload;
in vec3 v_position;

void sc_compute() {
    sc_payload = sin(v_position * 12.9) * sin(v_position.yzx * 78.2);
}

// After a reset all payloads are new. They start with different ages, or all would be too old in the
// same frame.
void sc_stagger() {
    if (sc_reset != 0) {
        uvec2 block = uvec2(gl_FragCoord.xy / float(sc_block));
        uint hashed = (block.x * 1973u + block.y * 9277u + 26699u) * 0x9E3779B9u;
        hashed = (hashed ^ hashed >> 15) * 0x85EBCA6Bu;
        sc_age = float((hashed >> 16) * uint(sc_period) >> 16);
    }
}

// What is stored of the payloads.
vec4 sc_pack() {
    return vec4(sc_payload, 16.0 / sc_current.w);
}

vec4 sc_pack_2() {
    return vec4(sc_age, 0.0, 0.0, 0.0);
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
        sc_store_2 = sc_held(sc_store_2);
    }
}

// Marks a texel that must not be reused. The third of three passes reads it in this frame, so it
// holds what was computed, or what comes nearest of larger numbers.
void sc_guard() {
    bool unfit = sc_unfit(sc_store) || sc_unfit(sc_store_2);
    if (unfit) {
        sc_hold();
        sc_store.w = sc_poison_depth;
    }
}

// Three passes, second: the payload alone, for the pixels that the first pass left open.
void main() {
    sc_compute();
    sc_stagger();
    sc_store = sc_pack();
    sc_store_2 = sc_pack_2();
    sc_guard();
}

#version 330
// shadercache: 3-pass.shade, node main.0-ca91d057

uniform sampler2D sc_payloads; // what this frame has stored so far
vec3 sc_payload;
uniform vec3 u_tint;
in vec3 v_normal;
layout(location = 0) out vec4 o_color;

void sc_shade() {
    vec3 albedo = sc_payload;
    o_color = vec4(albedo * dot(normalize(v_normal), u_tint), 1.0);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    sc_payload = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0).xyz;
    sc_shade();
}
