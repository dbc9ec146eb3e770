#version 330
// SC316: the left side of && decides whether the right one discards.
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

bool cut() {
    if (v_uv.x < 2.0) discard;
    return true;
}

void main() {
    float edge = 0.0;
    if (u_time < 2.0) {
        float n = costly(v_position);
        if (n > 0.3 && cut()) {
            edge = 0.5;
        }
    }
    o_color = vec4(edge, v_uv, 1.0);
}
