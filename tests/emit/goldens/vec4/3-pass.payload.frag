#version 330
// shadercache: 3-pass.payload, node main.11-ff053a83

in vec4 sc_current;
vec4 sc_payload;
layout(location = 1) out vec4 sc_store;
layout(location = 2) out vec4 sc_store_2;
uniform float sc_limit;
uniform float sc_least;
in vec3 v_position;
in vec3 v_normal;
layout(location = 0) out vec4 o_color;

void sc_shade() {
    vec4 wave = sin(9.0 * v_position.xyzx) * cos(5.0 * v_position.yzxy);
    sc_payload = wave * wave.yzwx;
    vec4 it = sc_payload;
    o_color = vec4(0.5 + 0.5 * (it.xyz * it.w) * normalize(v_normal).z, 1.0);
}

vec4 sc_texel() {
    return vec4(sc_payload.xyz, 16.0 / sc_current.w);
}

vec4 sc_texel_2() {
    return vec4(sc_payload.w, 0.0, 0.0, 0.0);
}

bool sc_unfit(vec4 values) {
    vec4 sizes = abs(values);
    return any(isnan(values)) || any(greaterThan(sizes, vec4(sc_limit))) || any(lessThan(sizes, sc_least * vec4(notEqual(values, vec4(0.0)))));
}

void sc_guard() {
    bool unfit = sc_unfit(sc_store);
    unfit = unfit || sc_unfit(sc_store_2);
    if (unfit && sc_store.w != 0.0) {
        sc_store = vec4(0.0, 0.0, 0.0, 32768.0);
        sc_store_2 = vec4(0);
    }
}

void main() {
    sc_shade();
    sc_store = sc_texel();
    sc_store_2 = sc_texel_2();
    sc_guard();
}
