#version 330
// SC315: written back, then read in the same conditional.
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

float slope(float x) { return fwidth(x); }
void wave(vec3 p, out float found) { found = p.x; }

void main() {
    float edge = 0.0;
    if (u_time < 2.0) {
        float n = costly(v_position);
        float height = 0.0;
        wave(vec3(n), height);
        edge = slope(height);
    }
    o_color = vec4(edge, v_uv, 1.0);
}
