#version 330
uniform sampler2D u_map;
uniform samplerCube u_sky;
uniform vec3 u_tint;
uniform float u_time;

//// Hits are shaded; what misses need is parked, fetches with implicit level of detail among it.
//// node: noise(p) + 0.5 * noise(p * 2.0)
//// by: parked
//// shows: parked.find.frag sc_fetch_ahead sc_park_1 sc_park_2 sc_park_3 sc_park sc_stone_1 main
//// shows: parked.mark.frag
//// shows: parked.fix-up.frag
//// shows: parked.fix-up.vert
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;
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
    o_color = vec4(stone(v_position) * max(dot(normal, u_tint), 0.0), 1.0);
}
//// becomes
layout(location = 2) out uvec4 sc_park_1;
layout(location = 3) out uvec4 sc_park_2;
layout(location = 4) out uvec3 sc_park_3;
vec3 sc_stone_1(vec3 p) {
    float octaves = sc_payload + 0.25 * noise(p * 4.0);
    vec4 grain = sc_fetch_0;
    return mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
}
void sc_fetch_ahead() {
    sc_fetch_0_ahead();
}
void sc_park() {
    sc_park_1 = uvec4(floatBitsToUint(sc_current.w), floatBitsToUint(v_position.x), floatBitsToUint(v_position.y), floatBitsToUint(v_position.z));
    sc_park_2 = uvec4(floatBitsToUint(v_normal.x), floatBitsToUint(v_normal.y), floatBitsToUint(v_normal.z), floatBitsToUint(sc_fetch_0.x));
    sc_park_3 = uvec3(floatBitsToUint(sc_fetch_0.y), floatBitsToUint(sc_fetch_0.z), floatBitsToUint(sc_fetch_0.w));
}
void main() {
    sc_fetch_ahead();
    vec4 sc_texel;
    sc_lacks = sc_look_up(sc_texel) != sc_hit;
    sc_park();
    sc_payload = sc_texel.x;
    sc_shade();
    sc_store = sc_pack();
    if (sc_lacks) {
        sc_store = vec4(float(sc_group), 0.0, 0.0, sc_missed_depth);
    }
}

#version 330
// shadercache: parked.mark, node stone.1-af9fb899

const float sc_missed_depth = -49152.0; // of a texel that this frame is yet to compute
uniform sampler2D sc_payloads; // what this frame has stored so far

// Parked misses, second: a depth for each pixel that waits, by the number of its group; the farthest
// depth for all others.
void main() {
    vec4 texel = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0);
    bool missed = texel.w == sc_missed_depth;
    // What is not a parked pixel may hold anything, infinities among it.
    float share = missed ? 0.75 + float(texel.x) / 8192.0 : 1.0;
    gl_FragDepth = mix(gl_FragCoord.z, gl_DepthRange.far, share);
}

#version 330
// shadercache: parked.fix-up, node stone.1-af9fb899

uniform usampler2D sc_parked_1;
uniform usampler2D sc_parked_2;
uniform usampler2D sc_parked_3;
vec4 sc_fetch_0;
const float sc_poison_depth = -65504.0; // depth of what must not be reused
uniform float sc_limit; // the largest value that is reused
uniform float sc_least; // the smallest one above zero that it surely holds
vec4 sc_current; // clip-space position in this frame
layout(location = 1) out vec4 sc_store; // what the next frame finds in the cache
float sc_payload;
uniform vec3 u_tint;
vec3 v_position;
vec3 v_normal;
layout(location = 0) out vec4 o_color;

float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}

vec3 sc_stone(vec3 p) {
    sc_payload = noise(p) + 0.5 * noise(p * 2.0);
    float octaves = sc_payload + 0.25 * noise(p * 4.0);
    vec4 grain = sc_fetch_0;
    return mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
}

void sc_shade() {
    vec3 normal = normalize(v_normal);
    o_color = vec4(sc_stone(v_position) * max(dot(normal, u_tint), 0.0), 1.0);
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

void sc_unpark() {
    ivec2 sc_place = ivec2(gl_FragCoord.xy);
    uvec4 sc_lanes_1 = texelFetch(sc_parked_1, sc_place, 0);
    uvec4 sc_lanes_2 = texelFetch(sc_parked_2, sc_place, 0);
    uvec4 sc_lanes_3 = texelFetch(sc_parked_3, sc_place, 0);
    sc_current.w = uintBitsToFloat(sc_lanes_1.x);
    v_position.xyz = uintBitsToFloat(sc_lanes_1.yzw);
    v_normal.xyz = uintBitsToFloat(sc_lanes_2.xyz);
    sc_fetch_0.xyzw = uintBitsToFloat(uvec4(sc_lanes_2.w, sc_lanes_3.xyz));
}

// Parked misses, third: the whole shader, for the pixels that wait; all that it needs was parked.
void main() {
    sc_unpark();
    sc_shade();
    sc_store = sc_pack();
    sc_guard();
}

#version 330
// shadercache: parked.fix-up, node stone.1-af9fb899

// One triangle over the whole target, at the depth that marks the misses of a group.
uniform int sc_group; // its number, from 1

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(4.0 * corner - 1.0, 0.75 + float(sc_group) / 8192.0, 1.0);
}

//// With levels of detail the fetches themselves are made by whoever needs them.
//// node: sin(v_position * 12.9) * cos(v_position.yzx * 78.2)
//// by: parked
//// fetches: level
//// shows: parked.find.frag sc_fetch_ahead sc_fetch_0_ahead sc_park_1 sc_park_2 sc_park main sc_shade
//// shows: parked.fix-up.frag sc_unpark sc_shade
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;
void main() {
    vec3 waves = sin(v_position * 12.9) * cos(v_position.yzx * 78.2);
    o_color = vec4(waves * texture(u_map, v_uv * 3.0).rgb, 1.0);
}
//// becomes
layout(location = 2) out uvec4 sc_park_1;
layout(location = 3) out uvec3 sc_park_2;
void sc_fetch_0_ahead() {
    sc_fetch_0 = textureQueryLod(u_map, v_uv * 3.0).y;
}
void sc_shade() {
    vec3 waves = sc_payload;
    o_color = vec4(waves * textureLod(u_map, v_uv * 3.0, sc_fetch_0).rgb, 1.0);
}
void sc_fetch_ahead() {
    sc_fetch_0_ahead();
}
void sc_park() {
    sc_park_1 = uvec4(floatBitsToUint(sc_current.w), floatBitsToUint(v_position.x), floatBitsToUint(v_position.y), floatBitsToUint(v_position.z));
    sc_park_2 = uvec3(floatBitsToUint(v_uv.x), floatBitsToUint(v_uv.y), floatBitsToUint(sc_fetch_0));
}
void main() {
    sc_fetch_ahead();
    vec4 sc_texel;
    sc_lacks = sc_look_up(sc_texel) != sc_hit;
    sc_park();
    sc_payload = sc_texel.xyz;
    sc_shade();
    sc_store = sc_pack();
    if (sc_lacks) {
        sc_store = vec4(float(sc_group), 0.0, 0.0, sc_missed_depth);
    }
}

void sc_shade() {
    sc_payload = sin(v_position * 12.9) * cos(v_position.yzx * 78.2);
    vec3 waves = sc_payload;
    o_color = vec4(waves * textureLod(u_map, v_uv * 3.0, sc_fetch_0).rgb, 1.0);
}
void sc_unpark() {
    ivec2 sc_place = ivec2(gl_FragCoord.xy);
    uvec4 sc_lanes_1 = texelFetch(sc_parked_1, sc_place, 0);
    uvec4 sc_lanes_2 = texelFetch(sc_parked_2, sc_place, 0);
    sc_current.w = uintBitsToFloat(sc_lanes_1.x);
    v_position.xyz = uintBitsToFloat(sc_lanes_1.yzw);
    v_uv.xy = uintBitsToFloat(sc_lanes_2.xy);
    sc_fetch_0 = uintBitsToFloat(sc_lanes_2.z);
}

//// Inputs of every kind, and what only the object's own draw knows.
//// node: sin(v_rows * v_rows[1] * 12.9)
//// by: parked
//// ids: on
//// shows: parked.find.frag sc_park_1 sc_park_4 sc_park
//// shows: parked.fix-up.frag v_rows v_kind sc_front_facing sc_frag_coord sc_unpark sc_shade main
in mat3 v_rows;
flat in int v_kind;
flat in uvec2 v_pair;
noperspective centroid in vec3 v_place;
out vec4 o_color;
void main() {
    vec3 waves = sin(v_rows * v_rows[1] * 12.9) + v_place;
    float side = gl_FrontFacing ? gl_FragCoord.z : gl_FragCoord.w * gl_FragCoord.x;
    o_color = vec4(waves * side, float(v_kind) + float(v_pair.y));
}
//// vertex
#version 330
in vec3 a_position;
uniform mat4 u_modelViewProjection;
out mat3 v_rows;
flat out int v_kind;
flat out uvec2 v_pair;
noperspective centroid out vec3 v_place;
void main() {
    v_rows = mat3(u_modelViewProjection);
    v_kind = gl_VertexID;
    v_pair = uvec2(7u, gl_VertexID);
    v_place = a_position;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}
//// becomes
layout(location = 3) out uvec4 sc_park_1;
layout(location = 6) out uvec4 sc_park_4;
void sc_park() {
    sc_park_1 = uvec4(floatBitsToUint(sc_current.w), floatBitsToUint(v_rows[0].x), floatBitsToUint(v_rows[0].y), floatBitsToUint(v_rows[0].z));
    sc_park_2 = uvec4(floatBitsToUint(v_rows[1].x), floatBitsToUint(v_rows[1].y), floatBitsToUint(v_rows[1].z), floatBitsToUint(v_rows[2].x));
    sc_park_3 = uvec4(floatBitsToUint(v_rows[2].y), floatBitsToUint(v_rows[2].z), uint(v_kind), v_pair.y);
    sc_park_4 = uvec4(floatBitsToUint(v_place.x), floatBitsToUint(v_place.y), floatBitsToUint(v_place.z), uint(sc_object));
    sc_park_5 = uvec3(uint(gl_FrontFacing), floatBitsToUint(gl_FragCoord.z), floatBitsToUint(gl_FragCoord.w));
}

vec4 sc_frag_coord;
bool sc_front_facing;
mat3 v_rows;
int v_kind;
void sc_shade() {
    sc_payload = sin(v_rows * v_rows[1] * 12.9);
    vec3 waves = sc_payload + v_place;
    float side = sc_front_facing ? sc_frag_coord.z : sc_frag_coord.w * sc_frag_coord.x;
    o_color = vec4(waves * side, float(v_kind) + float(v_pair.y));
}
void sc_unpark() {
    ivec2 sc_place = ivec2(gl_FragCoord.xy);
    uvec4 sc_lanes_1 = texelFetch(sc_parked_1, sc_place, 0);
    uvec4 sc_lanes_2 = texelFetch(sc_parked_2, sc_place, 0);
    uvec4 sc_lanes_3 = texelFetch(sc_parked_3, sc_place, 0);
    uvec4 sc_lanes_4 = texelFetch(sc_parked_4, sc_place, 0);
    uvec4 sc_lanes_5 = texelFetch(sc_parked_5, sc_place, 0);
    sc_frag_coord.xy = gl_FragCoord.xy;
    sc_current.w = uintBitsToFloat(sc_lanes_1.x);
    v_rows[0].xyz = uintBitsToFloat(sc_lanes_1.yzw);
    v_rows[1].xyz = uintBitsToFloat(sc_lanes_2.xyz);
    v_rows[2].xyz = uintBitsToFloat(uvec3(sc_lanes_2.w, sc_lanes_3.xy));
    v_kind = int(sc_lanes_3.z);
    v_pair.y = sc_lanes_3.w;
    v_place.xyz = uintBitsToFloat(sc_lanes_4.xyz);
    sc_object = int(sc_lanes_4.w);
    sc_front_facing = bool(sc_lanes_5.x);
    sc_frag_coord.zw = uintBitsToFloat(sc_lanes_5.yz);
}
void main() {
    sc_unpark();
    sc_shade();
    sc_store = sc_pack();
    sc_store_2 = sc_pack_2();
    sc_guard();
}

//// Not every fragment needs the payload, and those that do not are shaded at once.
//// node: sin(v_position * 12.9) * cos(v_position.yzx * 78.2)
//// by: parked
//// shows: parked.find.frag main sc_shade
//// shows: parked.fix-up.frag main sc_shade
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;
void main() {
    vec3 color = u_tint;
    if (v_uv.x > 0.5) {
        color += sin(v_position * 12.9) * cos(v_position.yzx * 78.2);
    }
    o_color = vec4(color, 1.0);
}
//// becomes
void sc_shade() {
    vec3 color = u_tint;
    if (v_uv.x > 0.5) {
        if (!sc_reuse) {
            sc_lacks = true;
        }
        color += sc_payload;
    }
    o_color = vec4(color, 1.0);
}
void main() {
    vec4 sc_texel;
    sc_reuse = sc_look_up(sc_texel) == sc_hit;
    sc_park();
    sc_valid = sc_reuse;
    sc_payload = sc_texel.xyz;
    sc_shade();
    sc_store = sc_pack();
    if (!sc_reuse) {
        sc_guard();
    }
    if (sc_lacks) {
        sc_store = vec4(float(sc_group), 0.0, 0.0, sc_missed_depth);
    }
}

void sc_shade() {
    vec3 color = u_tint;
    if (v_uv.x > 0.5) {
        sc_payload = sin(v_position * 12.9) * cos(v_position.yzx * 78.2);
        sc_valid = true;
        color += sc_payload;
    }
    o_color = vec4(color, 1.0);
}
void main() {
    sc_unpark();
    sc_shade();
    sc_store = sc_pack();
    sc_guard();
}

//// With periods that adapt what the look-up has found is parked too.
//// node: sin(v_position.x * 12.9) * cos(v_position.y * 78.2)
//// by: parked
//// adaptive: 0.1
//// shows: parked.find.frag sc_park_1 sc_park_2 sc_park main
//// shows: parked.fix-up.frag sc_unpark main
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;
void main() {
    float waves = sin(v_position.x * 12.9) * cos(v_position.y * 78.2);
    o_color = vec4(u_tint * waves, 1.0);
}
//// becomes
layout(location = 2) out uvec4 sc_park_1;
layout(location = 3) out uvec2 sc_park_2;
void sc_park() {
    sc_park_1 = uvec4(floatBitsToUint(sc_current.w), floatBitsToUint(v_position.x), floatBitsToUint(v_position.y), floatBitsToUint(sc_halvings));
    sc_park_2 = uvec2(uint(sc_refreshed), floatBitsToUint(sc_old_0));
}
void main() {
    vec4 sc_texel;
    sc_lacks = sc_look_up(sc_texel) != sc_hit;
    sc_park();
    sc_payload = sc_texel.x;
    sc_shade();
    sc_store = sc_pack();
    if (sc_lacks) {
        sc_store = vec4(float(sc_group), 0.0, 0.0, sc_missed_depth);
    }
}

void sc_unpark() {
    ivec2 sc_place = ivec2(gl_FragCoord.xy);
    uvec4 sc_lanes_1 = texelFetch(sc_parked_1, sc_place, 0);
    uvec4 sc_lanes_2 = texelFetch(sc_parked_2, sc_place, 0);
    sc_current.w = uintBitsToFloat(sc_lanes_1.x);
    v_position.xy = uintBitsToFloat(sc_lanes_1.yz);
    sc_halvings = uintBitsToFloat(sc_lanes_1.w);
    sc_refreshed = bool(sc_lanes_2.x);
    sc_old_0 = uintBitsToFloat(sc_lanes_2.y);
}
void main() {
    sc_unpark();
    sc_shade();
    sc_adapt();
    sc_store = sc_pack();
    sc_guard();
}
