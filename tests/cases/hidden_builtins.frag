#version 330
// Functions and variables that take the names of built-in ones.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float sin(float x) { return x - x * x * x / 6.0; }
vec3 normalize(vec3 v) { return v * 0.5 + 0.5; }
float length = 2.0;

float wave(vec3 p) { return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z); }

void main() {
    float dot = wave(v_position) * length;
    float texture = wave(normalize(v_normal)) + dot;
    float cos = texture * 0.5 + sin(v_uv.x);
    o_color = vec4(dot, texture, cos, 1.0);
}
