#version 330
// shadercache: 3-pass.payload, node stone.27-f6bd6cd8

in vec4 sc_current;
vec3 sc_payload;
layout(location = 0) out vec4 sc_store;
uniform float sc_limit;
uniform float sc_least;
uniform sampler2D u_map;
in vec3 v_position;

void sc_stone(vec3 p) {
    vec4 grain = texture(u_map, p.xy);
    sc_payload = grain.rgb;
}

void sc_compute() {
    sc_stone(v_position);
}

vec4 sc_texel() {
    return vec4(sc_payload, 16.0 / sc_current.w);
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
    sc_compute();
    sc_store = sc_texel();
    sc_guard();
}
