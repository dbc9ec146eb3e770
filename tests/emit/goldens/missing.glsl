const uint sc_missed_depth = 2u;  // of a texel that this frame is yet to compute
const uint sc_no_depth = 0u;  // of an empty texel: it matches nothing
const uint sc_poison_depth = 1u;  // depth of what must not be reused
const uvec4 sc_discrete = uvec4(0u, 0u, 0xFFFFFFFFu, 0u);  // bits that are no float's
const uvec4 sc_discrete_2 = uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0u);  // bits that are no float's
highp vec2 sc_payload_1;
bool sc_payload_2;
highp ivec3 sc_payload_3;
bool sc_valid_1 = false;  // is there a payload to store?
bool sc_valid_2 = false;  // is there a payload to store?
bool sc_valid_3 = false;  // is there a payload to store?
void sc_UNPACK() { sc_payload_1 = uintBitsToFloat(sc_texel.xy); sc_payload_2 = bool(sc_texel.z); sc_payload_3 = ivec3(sc_texel_2.xyz); }
void sc_TAKE() { sc_TEXELS sc_texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0); sc_payload_1 = uintBitsToFloat(sc_texel.xy); sc_payload_2 = bool(sc_texel.z); sc_payload_3 = ivec3(sc_texel_2.xyz); }
void sc_VALUE() { sc_value = vec4(uvec4(sc_valid_1 ? floatBitsToUint(sc_payload_1) : uvec2(0u), sc_valid_2 ? uint(sc_payload_2) : 0u, 1u)); sc_value += vec4(uvec4(sc_valid_3 ? uvec3(sc_payload_3) : uvec3(0u), 0u)); }
bool sc_VALID() { return sc_valid_1 && sc_valid_2 && sc_valid_3; }
void sc_SET_VALID(bool value) { sc_valid_1 = value; sc_valid_2 = value; sc_valid_3 = value; }
// What is stored of the payloads, if there are any.
uvec4 sc_pack() { return uvec4(sc_valid_1 ? floatBitsToUint(sc_payload_1) : uvec2(0u), sc_valid_2 ? uint(sc_payload_2) : 0u, sc_valid_1 && sc_valid_2 && sc_valid_3 ? sc_KEPT_DEPTH() : sc_no_depth); }
uvec4 sc_pack_2() { return uvec4(sc_valid_3 ? uvec3(sc_payload_3) : uvec3(0u), 0u); }
uvec4 sc_PACKED() { return uvec4(sc_valid_1 ? floatBitsToUint(sc_payload_1) : uvec2(0u), sc_valid_2 ? uint(sc_payload_2) : 0u, 0); }
uvec4 sc_PACKED_2() { return uvec4(sc_valid_3 ? uvec3(sc_payload_3) : uvec3(0u), 0u); }