#version 330
// Prototypes, unnamed and unused parameters, const and void ones, functions below main.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(const in vec3 p, float);
float below(void);
void set(out float x, const float y);

void main() {
    float a = wave(v_position, sin(v_uv.x * 9.0));
    float b;
    set(b, wave(v_normal, 0.0));
    o_color = vec4(a, b, below(), 1.0);
}

float wave(const in vec3 p, float unused) { return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7); }
float below() { return wave(v_position.zyx, 1.0) + wave(v_normal, 2.0); }
void set(out float x, const float y) { x = y * 0.5 + 0.25; }
