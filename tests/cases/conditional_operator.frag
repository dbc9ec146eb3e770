#version 330
// Payloads in and under ?:, with conditions that differ from pixel to pixel.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void main() {
    float a = v_uv.x > 0.5 ? wave(v_position) : wave(v_normal) * 0.5;
    float b = (v_uv.y > 0.3 ? v_uv.x > 0.6 ? wave(v_position * 2.0) : 0.25 : wave(v_normal * 3.0)) * a;
    float c = wave(v_position * 5.0) > 0.0 ? a : b;
    vec3 d = u_time > 0.0 ? normalize(v_normal) : normalize(v_position);
    o_color = vec4(a, b, c, dot(d, u_light) + 1.0);
}
