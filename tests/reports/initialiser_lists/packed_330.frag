#version 330 core
#extension GL_ARB_shading_language_420pack : require
#define PAIR(a, b) { a, b }
uniform float u_time;
uniform vec2 u_resolution;
const vec2 k_turn = PAIR(0.5, 0.25);
out vec4 colour;

float wave(vec2 p) {
    return exp(sin(p.x * 3.1 + u_time)) * sin(p.y * 2.7);
}

void main() {
    vec2 uv = gl_FragCoord.xy / u_resolution;
    vec2 v = PAIR(wave(uv), wave(uv.yx));
    mat2 m = PAIR(PAIR(1.0, wave(uv * 2.0)), PAIR(0.5, 0.5));
    float f[2] = PAIR(v.x, exp(sin(v.y)));
    colour = vec4(m * v * k_turn, f[0], f[1]);
}
