#version 330
// SC315: written in one conditional, read in another.
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

float level;
float slope() { return fwidth(level); }

void main() {
    float edge = 0.0;
    if (u_time < 2.0) {
        level = costly(v_position);
    }
    if (u_time < 3.0) {
        edge = slope();
    }
    o_color = vec4(edge, v_uv, 1.0);
}
