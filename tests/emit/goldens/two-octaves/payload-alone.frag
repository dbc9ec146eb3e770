#version 330
// shadercache: payload-alone, node stone.1-ae098caa

layout(location = 0) out vec4 sc_value;
float sc_payload;
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

// Not part of any variant: the payload alone, drawn like the original, to measure what it costs.
void main() {
    sc_compute();
    sc_value = vec4(sc_payload, 0.0, 0.0, 1.0);
}
