#version 330
// shadercache: 3-pass.payload, node stone.1-ae098caa, node stone.27-f6bd6cd8

in vec4 sc_current;
float sc_payload_1;
vec3 sc_payload_2;
layout(location = 0) out vec4 sc_store;
layout(location = 1) out vec4 sc_store_2;
uniform float sc_limit;
uniform float sc_least;
uniform sampler2D u_map;
in vec3 v_position;

float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}

void sc_stone(vec3 p) {
    sc_payload_1 = noise(p) + 0.5 * noise(p * 2.0);
    vec4 grain = texture(u_map, p.xy);
    sc_payload_2 = grain.rgb;
}

void sc_compute() {
    sc_stone(v_position);
}

vec4 sc_texel() {
    return vec4(sc_payload_1, sc_payload_2.xy, 16.0 / sc_current.w);
}

vec4 sc_texel_2() {
    return vec4(sc_payload_2.z, 0.0, 0.0, 0.0);
}

vec4 sc_held(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    vec4 held = mix(clamp(values, vec4(-sc_limit), vec4(sc_limit)), values, greaterThanEqual(sizes, uvec4(0x7F800000u)));
    return mix(values, held, greaterThan(sizes, uvec4(floatBitsToUint(sc_limit))));
}

void sc_hold() {
    if (sc_limit <= 65504.0) {
        sc_store = sc_held(sc_store);
        sc_store_2 = sc_held(sc_store_2);
    }
}

bool sc_unfit(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    return any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit)))) || any(lessThan(sizes - 1u, uvec4(least)));
}

void sc_guard() {
    bool unfit = sc_unfit(sc_store);
    unfit = unfit || sc_unfit(sc_store_2);
    if (unfit) {
        sc_hold();
        sc_store.w = -65504.0;
    }
}

void main() {
    sc_compute();
    sc_store = sc_texel();
    sc_store_2 = sc_texel_2();
    sc_guard();
}
