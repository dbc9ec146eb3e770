#version 330
// shadercache: 3-pass.payload, node stone.27-f6bd6cd8

in vec4 sc_current;
vec3 sc_payload;
layout(location = 0) out vec4 sc_store;
uniform sampler2D u_map;
in vec3 v_position;

void sc_stone(vec3 p) {
    vec4 grain = texture(u_map, p.xy);
    sc_payload = grain.rgb;
}

void sc_compute() {
    sc_stone(v_position);
}

vec4 sc_texel() {
    return vec4(sc_payload, 16.0 / sc_current.w);
}

void main() {
    sc_compute();
    sc_store = sc_texel();
}
