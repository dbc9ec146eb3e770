#version 330
// shadercache: 2-pass.miss, node stone.1-ae098caa

in vec4 sc_current;
float sc_payload;
layout(location = 1) out vec4 sc_store;
uniform float sc_limit;
uniform float sc_least;
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
    sc_payload = noise(p) + 0.5 * noise(p * 2.0);
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

vec4 sc_texel() {
    return vec4(sc_payload, 0.0, 0.0, 16.0 / sc_current.w);
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
    sc_shade();
    sc_store = sc_texel();
    sc_guard();
}
