#version 330
// shadercache: payload-alone, node main.11-a0ace7bc

layout(location = 0) out vec4 sc_value;
in vec3 v_position;

struct Pair {
    vec2 a;
    float b;
};

struct Mixed {
    Pair pair;
    bool sign;
    ivec2 cell;
    uint number;
};

Mixed sc_payload;

void sc_compute() {
    vec4 wave = sin(9.0 * v_position.xyzx) * cos(5.0 * v_position.yzxy);
    sc_payload = Mixed(Pair(wave.xy, wave.z), wave.x > 0.3, ivec2(2.0 * wave.yz), uint(3.0 + wave.x));
}

// Not part of any variant: the payload alone, drawn like the original, to measure what it costs.
void main() {
    sc_compute();
    sc_value = vec4(uvec4(floatBitsToUint(sc_payload.pair.a), floatBitsToUint(sc_payload.pair.b), 1u));
    sc_value += vec4(uvec4(uint(sc_payload.sign), uvec2(sc_payload.cell), sc_payload.number));
}
