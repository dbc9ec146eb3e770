#version 400
// shadercache: 2-pass.miss, node stone.1-ae098caa

invariant in vec4 sc_current;
precise float sc_payload;
layout(location = 1) precise out vec4 sc_store;
uniform float sc_limit;
uniform float sc_least;
uniform sampler2D u_map;
uniform vec3 u_tint;
invariant in vec3 v_position;
invariant in vec3 v_normal;
invariant in vec2 v_uv;
layout(location = 0) precise out vec4 o_color;

float noise(vec3 p) {
    precise float sc_exact_1 = sin(p.x * 12.9 - float(gl_FragCoord.x < 0.0)) * sin(p.y * 78.2 - float(gl_FragCoord.x < 0.0)) * sin(p.z * 37.7 - float(gl_FragCoord.x < 0.0));
    return sc_exact_1;
}

vec3 sc_stone(vec3 p) {
    precise vec3 sc_exact_1 = p * 2.0;
    sc_payload = noise(p) + 0.5 * noise(sc_exact_1);
    precise vec3 sc_exact_2 = p * 4.0;
    precise float octaves = sc_payload + 0.25 * noise(sc_exact_2);
    precise vec4 grain = texture(u_map, p.xy);
    precise vec3 sc_exact_3 = mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
    return sc_exact_3;
}

void sc_shade() {
    precise vec3 normal = normalize(v_normal - float(gl_FragCoord.x < 0.0));
    precise vec3 albedo = sc_stone(v_position);
    precise float light = max(dot(normal, u_tint), float(gl_FragCoord.x < 0.0));
    o_color = vec4(albedo * light + texture(u_map, v_uv).rgb, 1.0);
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
    sc_shade();
    sc_store = sc_texel();
    sc_guard();
}
