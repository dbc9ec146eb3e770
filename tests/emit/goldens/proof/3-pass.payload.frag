#version 400
// shadercache: 3-pass.payload, node stone.1-ae098caa

invariant in vec4 sc_current;
precise float sc_payload;
layout(location = 0) precise out vec4 sc_store;
uniform float sc_limit;
uniform float sc_least;
invariant in vec3 v_position;

float noise(vec3 p) {
    precise float sc_exact_1 = sin(p.x * 12.9 - float(gl_FragCoord.x < 0.0)) * sin(p.y * 78.2 - float(gl_FragCoord.x < 0.0)) * sin(p.z * 37.7 - float(gl_FragCoord.x < 0.0));
    return sc_exact_1;
}

void sc_stone(vec3 p) {
    precise vec3 sc_exact_1 = p * 2.0;
    sc_payload = noise(p) + 0.5 * noise(sc_exact_1);
}

void sc_compute() {
    sc_stone(v_position);
}

vec4 sc_texel() {
    precise vec4 sc_exact_1 = vec4(sc_payload, float(gl_FragCoord.x < 0.0), float(gl_FragCoord.x < 0.0), 16.0 / sc_current.w);
    return sc_exact_1;
}

vec4 sc_held(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    precise vec4 held = mix(clamp(values, vec4(-sc_limit), vec4(sc_limit)), values, greaterThanEqual(sizes, uvec4(0x7F800000u)));
    precise vec4 sc_exact_1 = mix(values, held, greaterThan(sizes, uvec4(floatBitsToUint(sc_limit))));
    return sc_exact_1;
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
