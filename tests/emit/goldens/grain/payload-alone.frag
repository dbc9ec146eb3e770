#version 330
// shadercache: payload-alone, node stone.27-f6bd6cd8

layout(location = 0) out vec4 sc_value;
vec3 sc_payload;
uniform sampler2D u_map;
in vec3 v_position;

void sc_stone(vec3 p) {
    vec4 grain = texture(u_map, p.xy);
    sc_payload = grain.rgb;
}

void sc_compute() {
    sc_stone(v_position);
}

// Not part of any variant: the payload alone, drawn like the original, to measure what it costs.
void main() {
    sc_compute();
    sc_value = vec4(sc_payload, 1.0);
}
