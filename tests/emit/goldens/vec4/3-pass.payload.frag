#version 330
// shadercache: 3-pass.payload, node main.11-ff053a83

in vec4 sc_current;
vec4 sc_payload;
layout(location = 0) out vec4 sc_store;
layout(location = 1) out vec4 sc_store_2;
in vec3 v_position;

void sc_compute() {
    vec4 wave = sin(9.0 * v_position.xyzx) * cos(5.0 * v_position.yzxy);
    sc_payload = wave * wave.yzwx;
}

vec4 sc_texel() {
    return vec4(sc_payload.xyz, 16.0 / sc_current.w);
}

vec4 sc_texel_2() {
    return vec4(sc_payload.w, 0.0, 0.0, 0.0);
}

void main() {
    sc_compute();
    sc_store = sc_texel();
    sc_store_2 = sc_texel_2();
}
