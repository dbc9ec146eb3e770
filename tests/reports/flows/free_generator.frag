#version 330
// offered: a function keeps its own state in a global.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
uniform sampler2D u_map;
uniform samplerCube u_sky;
out vec4 o_color;

float costly(vec3 p) {
    return sin(exp(p.x) * 9.0) * cos(exp(p.y) * 7.0);
}

float seed;
float random() {
    seed = fract(sin(seed + v_uv.x) * 437.0);
    return seed;
}
float slope() { return fwidth(seed); }

void main() {
    seed = v_uv.y;
    float a = random() + slope();
    float c = costly(v_position);
    float b = random() * c;
    o_color = vec4(a, b, v_uv.x, 1.0);
}
