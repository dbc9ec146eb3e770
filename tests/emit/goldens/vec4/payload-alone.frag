#version 330
// shadercache: payload-alone, node main.11-ff053a83

vec4 sc_payload;
layout(location = 0) out vec4 sc_value;
in vec3 v_position;

void sc_compute() {
    vec4 wave = sin(9.0 * v_position.xyzx) * cos(5.0 * v_position.yzxy);
    sc_payload = wave * wave.yzwx;
}

void main() {
    sc_compute();
    sc_value = vec4(sc_payload.xyz, 1.0);
    sc_value += vec4(vec4(sc_payload.w, 0.0, 0.0, 0.0));
}
