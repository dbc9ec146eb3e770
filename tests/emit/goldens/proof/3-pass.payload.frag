#version 400
// shadercache: 3-pass.payload, node stone.1-ae098caa

invariant in vec4 sc_current;
precise float sc_payload;
layout(location = 0) precise out vec4 sc_store;
invariant in vec3 v_position;

float noise(vec3 p) {
    precise float sc_exact_1 = sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
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
    precise vec4 sc_exact_1 = vec4(sc_payload, 0.0, 0.0, 16.0 / sc_current.w);
    return sc_exact_1;
}

void main() {
    sc_compute();
    sc_store = sc_texel();
}
