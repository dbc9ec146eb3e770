#version 330
// shadercache: 3-pass.payload, node stone.1-ae098caa

in vec4 sc_current;
float sc_payload;
layout(location = 0) out vec4 sc_store;
in vec3 v_position;

float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}

void sc_stone(vec3 p) {
    sc_payload = noise(p) + 0.5 * noise(p * 2.0);
}

void sc_compute() {
    sc_stone(v_position);
}

vec4 sc_texel() {
    return vec4(sc_payload, 0.0, 0.0, 16.0 / sc_current.w);
}

void main() {
    sc_compute();
    sc_store = sc_texel();
}
