#version 430 core
uniform float u_time;
uniform vec2 u_resolution;
const float k_weights[] = { 1, 0.5, 0.25 };
const vec2 k_offsets[2][2] = { { { 0.0, 1.0 }, vec2(0.5) }, { { 1, 0 }, { 0.25, 0.75, } } };
vec2 scale[2] = { { 1.5, 2.5 }, { 3.5, 0.5 } };
out vec4 colour;

float wave(vec2 p) {
    float octaves[3] = { sin(p.x * 3.0 + u_time), exp(sin(p.y * 5.0)), sin(p.x * p.y * 7.0) };
    float sum = 0.0;
    for (int i = 0; i < 3; i++) {
        sum += octaves[i] * k_weights[i];
    }
    return sum;
}

void main() {
    vec2 uv = gl_FragCoord.xy / u_resolution;
    float grid[][2] = { { wave(uv), wave(uv.yx) }, { 0.5, wave(uv * 2.0) } };
    vec2 points[] = { uv * scale[0], { wave(uv + 1.0), 0.25 } };
    float near = exp(sin(grid[0][1] + grid[1][1])) * k_offsets[1][0].x;
    colour = vec4(near, points[1] * scale[1], 1.0);
}
