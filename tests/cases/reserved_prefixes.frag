#version 330
// Names that begin as the compiler's own do: sc_ and legacy_.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

uniform float sc_time;
uniform float legacy_texture;
float sc_ = 0.5;

struct sc_cache { float sc_depth; vec3 legacy_color; };

float sc_compute(vec3 sc_payload) {
    return sin(sc_payload.x * 3.0) * cos(sc_payload.y * 5.0 + sc_time);
}

float sc1_main(float legacy_x) { return legacy_x * legacy_texture + cos(legacy_x * 3.0); }

void main() {
    float sc_payload = sc_compute(v_position) + sc_;
    sc_cache sc_previous = sc_cache(sc1_main(sc_payload), normalize(v_normal) * sc_payload);
    o_color = vec4(sc_previous.legacy_color, sc_previous.sc_depth);
}
