#version 330
// Macros named like what the compiler adds; names in macros must not be taken either.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

#define sc_payload(x) ((x) * 2.0)
#define sc_hit 0.75
#define sc_shade sc_payload
#define SC_LOOKUP(name) float name = sc_payload(dot(v_position, u_light))
#define texelFetch_ texture

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void main() {
    SC_LOOKUP(sc_miss);
    float value = sc_payload(wave(v_position)) + sc_hit;
    o_color = vec4(sc_shade(value), wave(v_normal * value), sc_miss, 1.0);
}
