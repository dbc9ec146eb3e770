#version 330
// SC315: through three functions.
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
float twice(float x) { return slope(x * 2.0); }
float thrice(float x) { return twice(x) * 3.0; }

void main() {
    float edge = 0.0;
    if (u_time < 2.0) {
        float n = costly(v_position);
        edge = thrice(n + v_uv.x);
    }
    o_color = vec4(edge, v_uv, 1.0);
}
