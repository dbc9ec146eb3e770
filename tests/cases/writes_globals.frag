#version 330
// Functions that write globals which other functions read.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float seed;
vec3 tone = vec3(0.5);

float next() { seed = fract(seed * 7.13 + 0.37); return seed; }

void tint(float x) { tone.xz *= x; tone += wave(vec3(x)); }

void main() {
    float still = wave(v_normal);
    seed = fract(wave(v_position));
    float a = next() + next() * 0.5;
    float b = wave(v_position * 2.0) * next();
    tint(a);
    float c = wave(tone) + still;
    o_color = vec4(tone * b, c);
}
