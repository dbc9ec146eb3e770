#version 330
// shadercache: payload-alone, node main.11-ff053a83

layout(location = 0) out vec4 sc_value;
vec4 sc_payload;
in vec3 v_position;

void sc_compute() {
    vec4 wave = sin(9.0 * v_position.xyzx) * cos(5.0 * v_position.yzxy);
    sc_payload = wave * wave.yzwx;
}

// Not part of any variant: the payload alone, drawn like the original, to measure what it costs.
void main() {
    sc_compute();
    sc_value = vec4(sc_payload.xyz, 1.0);
    sc_value += vec4(vec4(sc_payload.w, 0.0, 0.0, 0.0));
}
