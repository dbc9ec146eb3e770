#version 330
// SC315: an element of an array carries it.
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

float slope(float x[3]) { return fwidth(x[1]); }

void main() {
    float edge = 0.0;
    if (u_time < 2.0) {
        float n = costly(v_position);
        float x[3] = float[3](0.0, 1.0, 2.0);
        x[1] = n;
        edge = slope(x);
    }
    o_color = vec4(edge, v_uv, 1.0);
}
