#version 330
// SC315: a global decides whether the function returns before its derivative.
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
float slope(float x) {
    if (level > 0.3) return 0.0;
    return fwidth(x);
}

void main() {
    level = costly(v_position);
    o_color = vec4(slope(v_uv.x), v_uv, 1.0);
}
