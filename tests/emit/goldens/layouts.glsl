// float: rgba16f
const float sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const float sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const float sc_poison_depth = -2.0;  // depth of what must not be reused
float sc_payload;
void sc_UNPACK() { sc_payload = sc_texel.x; }
void sc_TAKE() { sc_payload = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0).x; }
void sc_VALUE() { sc_value = vec4(sc_payload, 0.0, 0.0, 1.0); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
vec4 sc_pack() { return vec4(sc_payload, 0.0, 0.0, sc_KEPT_DEPTH()); }
vec4 sc_pack_2() { return vec4(0.0, 0.0, 0.0, 0.0); }
vec4 sc_PACKED() { return vec4(sc_payload, 0.0, 0.0, 0); }
vec4 sc_PACKED_2() { return vec4(0.0, 0.0, 0.0, 0.0); }
// vec3: rgba16f
const float sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const float sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const float sc_poison_depth = -2.0;  // depth of what must not be reused
vec3 sc_payload;
void sc_UNPACK() { sc_payload = sc_texel.xyz; }
void sc_TAKE() { sc_payload = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0).xyz; }
void sc_VALUE() { sc_value = vec4(sc_payload, 1.0); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
vec4 sc_pack() { return vec4(sc_payload, sc_KEPT_DEPTH()); }
vec4 sc_pack_2() { return vec4(0.0, 0.0, 0.0, 0.0); }
vec4 sc_PACKED() { return vec4(sc_payload, 0); }
vec4 sc_PACKED_2() { return vec4(0.0, 0.0, 0.0, 0.0); }
// vec4: rgba16f, r16f
const float sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const float sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const float sc_poison_depth = -2.0;  // depth of what must not be reused
vec4 sc_payload;
void sc_UNPACK() { sc_payload = vec4(sc_texel.xyz, sc_texel_2.x); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload = vec4(sc_texel.xyz, sc_texel_2.x); }
void sc_VALUE() { sc_value = vec4(sc_payload.xyz, 1.0); sc_value += vec4(vec4(sc_payload.w, 0.0, 0.0, 0.0)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
vec4 sc_pack() { return vec4(sc_payload.xyz, sc_KEPT_DEPTH()); }
vec4 sc_pack_2() { return vec4(sc_payload.w, 0.0, 0.0, 0.0); }
vec4 sc_PACKED() { return vec4(sc_payload.xyz, 0); }
vec4 sc_PACKED_2() { return vec4(sc_payload.w, 0.0, 0.0, 0.0); }
// int: rgba32ui
const uint sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const uint sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const uint sc_poison_depth = -2.0;  // depth of what must not be reused
const uvec4 sc_discrete = uvec4(0xFFFFFFFFu, 0u, 0u, 0u);  // bits that are no float's
const uvec4 sc_discrete_2 = uvec4(0u);  // bits that are no float's
int sc_payload;
void sc_UNPACK() { sc_payload = int(sc_texel.x); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload = int(sc_texel.x); }
void sc_VALUE() { sc_value = vec4(uvec4(uint(sc_payload), 0u, 0u, 1u)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
uvec4 sc_pack() { return uvec4(uint(sc_payload), 0u, 0u, sc_KEPT_DEPTH()); }
uvec4 sc_pack_2() { return uvec4(0u, 0u, 0u, 0u); }
uvec4 sc_PACKED() { return uvec4(uint(sc_payload), 0u, 0u, 0); }
uvec4 sc_PACKED_2() { return uvec4(0u, 0u, 0u, 0u); }
// uvec2: rgba32ui
const uint sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const uint sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const uint sc_poison_depth = -2.0;  // depth of what must not be reused
const uvec4 sc_discrete = uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0u, 0u);  // bits that are no float's
const uvec4 sc_discrete_2 = uvec4(0u);  // bits that are no float's
uvec2 sc_payload;
void sc_UNPACK() { sc_payload = sc_texel.xy; }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload = sc_texel.xy; }
void sc_VALUE() { sc_value = vec4(uvec4(sc_payload, 0u, 1u)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
uvec4 sc_pack() { return uvec4(sc_payload, 0u, sc_KEPT_DEPTH()); }
uvec4 sc_pack_2() { return uvec4(0u, 0u, 0u, 0u); }
uvec4 sc_PACKED() { return uvec4(sc_payload, 0u, 0); }
uvec4 sc_PACKED_2() { return uvec4(0u, 0u, 0u, 0u); }
// bool: rgba32ui
const uint sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const uint sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const uint sc_poison_depth = -2.0;  // depth of what must not be reused
const uvec4 sc_discrete = uvec4(0xFFFFFFFFu, 0u, 0u, 0u);  // bits that are no float's
const uvec4 sc_discrete_2 = uvec4(0u);  // bits that are no float's
bool sc_payload;
void sc_UNPACK() { sc_payload = bool(sc_texel.x); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload = bool(sc_texel.x); }
void sc_VALUE() { sc_value = vec4(uvec4(uint(sc_payload), 0u, 0u, 1u)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
uvec4 sc_pack() { return uvec4(uint(sc_payload), 0u, 0u, sc_KEPT_DEPTH()); }
uvec4 sc_pack_2() { return uvec4(0u, 0u, 0u, 0u); }
uvec4 sc_PACKED() { return uvec4(uint(sc_payload), 0u, 0u, 0); }
uvec4 sc_PACKED_2() { return uvec4(0u, 0u, 0u, 0u); }
// bvec4: rgba32ui, r32ui
const uint sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const uint sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const uint sc_poison_depth = -2.0;  // depth of what must not be reused
const uvec4 sc_discrete = uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0u);  // bits that are no float's
const uvec4 sc_discrete_2 = uvec4(0xFFFFFFFFu, 0u, 0u, 0u);  // bits that are no float's
bvec4 sc_payload;
void sc_UNPACK() { sc_payload = bvec4(sc_texel.xyz, sc_texel_2.x); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload = bvec4(sc_texel.xyz, sc_texel_2.x); }
void sc_VALUE() { sc_value = vec4(uvec4(uvec3(sc_payload.xyz), 1u)); sc_value += vec4(uvec4(uint(sc_payload.w), 0u, 0u, 0u)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
uvec4 sc_pack() { return uvec4(uvec3(sc_payload.xyz), sc_KEPT_DEPTH()); }
uvec4 sc_pack_2() { return uvec4(uint(sc_payload.w), 0u, 0u, 0u); }
uvec4 sc_PACKED() { return uvec4(uvec3(sc_payload.xyz), 0); }
uvec4 sc_PACKED_2() { return uvec4(uint(sc_payload.w), 0u, 0u, 0u); }
// mat2x3: rgba16f, rgba16f
const float sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const float sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const float sc_poison_depth = -2.0;  // depth of what must not be reused
mat2x3 sc_payload;
void sc_UNPACK() { sc_payload = mat2x3(sc_texel.xyz, sc_texel_2.xyz); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload = mat2x3(sc_texel.xyz, sc_texel_2.xyz); }
void sc_VALUE() { sc_value = vec4(sc_payload[0], 1.0); sc_value += vec4(vec4(sc_payload[1], 0.0)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
vec4 sc_pack() { return vec4(sc_payload[0], sc_KEPT_DEPTH()); }
vec4 sc_pack_2() { return vec4(sc_payload[1], 0.0); }
vec4 sc_PACKED() { return vec4(sc_payload[0], 0); }
vec4 sc_PACKED_2() { return vec4(sc_payload[1], 0.0); }
// vec2[2]: rgba16f, r16f
const float sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const float sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const float sc_poison_depth = -2.0;  // depth of what must not be reused
vec2[2] sc_payload;
void sc_UNPACK() { sc_payload = vec2[2](sc_texel.xy, vec2(sc_texel.z, sc_texel_2.x)); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload = vec2[2](sc_texel.xy, vec2(sc_texel.z, sc_texel_2.x)); }
void sc_VALUE() { sc_value = vec4(sc_payload[0], sc_payload[1].x, 1.0); sc_value += vec4(vec4(sc_payload[1].y, 0.0, 0.0, 0.0)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
vec4 sc_pack() { return vec4(sc_payload[0], sc_payload[1].x, sc_KEPT_DEPTH()); }
vec4 sc_pack_2() { return vec4(sc_payload[1].y, 0.0, 0.0, 0.0); }
vec4 sc_PACKED() { return vec4(sc_payload[0], sc_payload[1].x, 0); }
vec4 sc_PACKED_2() { return vec4(sc_payload[1].y, 0.0, 0.0, 0.0); }
// Flagged: rgba32ui, rgba32ui
const uint sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const uint sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const uint sc_poison_depth = -2.0;  // depth of what must not be reused
const uvec4 sc_discrete = uvec4(0u);  // bits that are no float's
const uvec4 sc_discrete_2 = uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu);  // bits that are no float's
Flagged sc_payload;
void sc_UNPACK() { sc_payload = Flagged(Ray(uintBitsToFloat(sc_texel.xyz), int(sc_texel_2.x)), bvec2(sc_texel_2.yz), sc_texel_2.w); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload = Flagged(Ray(uintBitsToFloat(sc_texel.xyz), int(sc_texel_2.x)), bvec2(sc_texel_2.yz), sc_texel_2.w); }
void sc_VALUE() { sc_value = vec4(uvec4(floatBitsToUint(sc_payload.ray.origin), 1u)); sc_value += vec4(uvec4(uint(sc_payload.ray.id), uvec2(sc_payload.flags), sc_payload.count)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
uvec4 sc_pack() { return uvec4(floatBitsToUint(sc_payload.ray.origin), sc_KEPT_DEPTH()); }
uvec4 sc_pack_2() { return uvec4(uint(sc_payload.ray.id), uvec2(sc_payload.flags), sc_payload.count); }
uvec4 sc_PACKED() { return uvec4(floatBitsToUint(sc_payload.ray.origin), 0); }
uvec4 sc_PACKED_2() { return uvec4(uint(sc_payload.ray.id), uvec2(sc_payload.flags), sc_payload.count); }
// Mixed: rgba32ui, rg32ui
const uint sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const uint sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const uint sc_poison_depth = -2.0;  // depth of what must not be reused
const uvec4 sc_discrete = uvec4(0u, 0u, 0xFFFFFFFFu, 0u);  // bits that are no float's
const uvec4 sc_discrete_2 = uvec4(0u, 0xFFFFFFFFu, 0u, 0u);  // bits that are no float's
Mixed sc_payload;
void sc_UNPACK() { sc_payload = Mixed(uintBitsToFloat(sc_texel.xy), int(sc_texel.z), uintBitsToFloat(sc_texel_2.x), bool(sc_texel_2.y)); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload = Mixed(uintBitsToFloat(sc_texel.xy), int(sc_texel.z), uintBitsToFloat(sc_texel_2.x), bool(sc_texel_2.y)); }
void sc_VALUE() { sc_value = vec4(uvec4(floatBitsToUint(sc_payload.at), uint(sc_payload.id), 1u)); sc_value += vec4(uvec4(floatBitsToUint(sc_payload.more), uint(sc_payload.on), 0u, 0u)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
uvec4 sc_pack() { return uvec4(floatBitsToUint(sc_payload.at), uint(sc_payload.id), sc_KEPT_DEPTH()); }
uvec4 sc_pack_2() { return uvec4(floatBitsToUint(sc_payload.more), uint(sc_payload.on), 0u, 0u); }
uvec4 sc_PACKED() { return uvec4(floatBitsToUint(sc_payload.at), uint(sc_payload.id), 0); }
uvec4 sc_PACKED_2() { return uvec4(floatBitsToUint(sc_payload.more), uint(sc_payload.on), 0u, 0u); }
// vec2, bool, ivec3: rgba32ui, rgba32ui
const uint sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const uint sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const uint sc_poison_depth = -2.0;  // depth of what must not be reused
const uvec4 sc_discrete = uvec4(0u, 0u, 0xFFFFFFFFu, 0u);  // bits that are no float's
const uvec4 sc_discrete_2 = uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0u);  // bits that are no float's
vec2 sc_payload_1;
bool sc_payload_2;
ivec3 sc_payload_3;
void sc_UNPACK() { sc_payload_1 = uintBitsToFloat(sc_texel.xy); sc_payload_2 = bool(sc_texel.z); sc_payload_3 = ivec3(sc_texel_2.xyz); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload_1 = uintBitsToFloat(sc_texel.xy); sc_payload_2 = bool(sc_texel.z); sc_payload_3 = ivec3(sc_texel_2.xyz); }
void sc_VALUE() { sc_value = vec4(uvec4(floatBitsToUint(sc_payload_1), uint(sc_payload_2), 1u)); sc_value += vec4(uvec4(uvec3(sc_payload_3), 0u)); }
bool sc_VALID() { return sc_valid_1 && sc_valid_2 && sc_valid_3; }
void sc_SET_VALID(bool value) { sc_valid_1 = value; sc_valid_2 = value; sc_valid_3 = value; }
// What is stored of the payloads.
uvec4 sc_pack() { return uvec4(floatBitsToUint(sc_payload_1), uint(sc_payload_2), sc_KEPT_DEPTH()); }
uvec4 sc_pack_2() { return uvec4(uvec3(sc_payload_3), 0u); }
uvec4 sc_PACKED() { return uvec4(floatBitsToUint(sc_payload_1), uint(sc_payload_2), 0); }
uvec4 sc_PACKED_2() { return uvec4(uvec3(sc_payload_3), 0u); }
// vec2, vec4: rgba16f, rgba16f
const float sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const float sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const float sc_poison_depth = -2.0;  // depth of what must not be reused
vec2 sc_payload_1;
vec4 sc_payload_2;
void sc_UNPACK() { sc_payload_1 = sc_texel.xy; sc_payload_2 = vec4(sc_texel.z, sc_texel_2.xyz); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload_1 = sc_texel.xy; sc_payload_2 = vec4(sc_texel.z, sc_texel_2.xyz); }
void sc_VALUE() { sc_value = vec4(sc_payload_1, sc_payload_2.x, 1.0); sc_value += vec4(vec4(sc_payload_2.yzw, 0.0)); }
bool sc_VALID() { return sc_valid_1 && sc_valid_2; }
void sc_SET_VALID(bool value) { sc_valid_1 = value; sc_valid_2 = value; }
// What is stored of the payloads.
vec4 sc_pack() { return vec4(sc_payload_1, sc_payload_2.x, sc_KEPT_DEPTH()); }
vec4 sc_pack_2() { return vec4(sc_payload_2.yzw, 0.0); }
vec4 sc_PACKED() { return vec4(sc_payload_1, sc_payload_2.x, 0); }
vec4 sc_PACKED_2() { return vec4(sc_payload_2.yzw, 0.0); }
// vec2, id, age: rgba16f, r16f
const float sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const float sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const float sc_poison_depth = -2.0;  // depth of what must not be reused
vec2 sc_payload;
void sc_UNPACK() { sc_payload = sc_texel.xy; }
void sc_TAKE() { sc_payload = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0).xy; }
void sc_VALUE() { sc_value = vec4(sc_payload, float(sc_object), 1.0); sc_value += vec4(vec4(sc_age, 0.0, 0.0, 0.0)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
vec4 sc_pack() { return vec4(sc_payload, float(sc_object), sc_KEPT_DEPTH()); }
vec4 sc_pack_2() { return vec4(sc_age, 0.0, 0.0, 0.0); }
vec4 sc_PACKED() { return vec4(sc_payload, float(sc_object), 0); }
vec4 sc_PACKED_2() { return vec4(sc_age, 0.0, 0.0, 0.0); }
int sc_ID(vec4 first, vec4 second) { return int(first.z); }
float sc_AGE(vec4 first, vec4 second) { return second.x; }
// int, id, age: rgba32ui
const uint sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const uint sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const uint sc_poison_depth = -2.0;  // depth of what must not be reused
const uvec4 sc_discrete = uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0u, 0u);  // bits that are no float's
const uvec4 sc_discrete_2 = uvec4(0u);  // bits that are no float's
int sc_payload;
void sc_UNPACK() { sc_payload = int(sc_texel.x); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload = int(sc_texel.x); }
void sc_VALUE() { sc_value = vec4(uvec4(uint(sc_payload), uint(sc_object), floatBitsToUint(sc_age), 1u)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
uvec4 sc_pack() { return uvec4(uint(sc_payload), uint(sc_object), floatBitsToUint(sc_age), sc_KEPT_DEPTH()); }
uvec4 sc_pack_2() { return uvec4(0u, 0u, 0u, 0u); }
uvec4 sc_PACKED() { return uvec4(uint(sc_payload), uint(sc_object), floatBitsToUint(sc_age), 0); }
uvec4 sc_PACKED_2() { return uvec4(0u, 0u, 0u, 0u); }
int sc_ID(uvec4 first, uvec4 second) { return int(first.y); }
float sc_AGE(uvec4 first, uvec4 second) { return uintBitsToFloat(first.z); }
// vec3, id: rgba16f, r16f
const float sc_missed_depth = -3.0;  // of a texel that this frame is yet to compute
const float sc_no_depth = -1.0;  // of an empty texel: it matches nothing
const float sc_poison_depth = -2.0;  // depth of what must not be reused
vec3 sc_payload;
void sc_UNPACK() { sc_payload = sc_texel.xyz; }
void sc_TAKE() { sc_payload = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0).xyz; }
void sc_VALUE() { sc_value = vec4(sc_payload, 1.0); sc_value += vec4(vec4(float(sc_object), 0.0, 0.0, 0.0)); }
bool sc_VALID() { return sc_valid; }
void sc_SET_VALID(bool value) { sc_valid = value; }
// What is stored of the payloads.
vec4 sc_pack() { return vec4(sc_payload, sc_KEPT_DEPTH()); }
vec4 sc_pack_2() { return vec4(float(sc_object), 0.0, 0.0, 0.0); }
vec4 sc_PACKED() { return vec4(sc_payload, 0); }
vec4 sc_PACKED_2() { return vec4(float(sc_object), 0.0, 0.0, 0.0); }
int sc_ID(vec4 first, vec4 second) { return int(second.x); }