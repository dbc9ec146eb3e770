#version 330
// SC316: and the call discards, so that a reused result would skip that.
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

float pick(float n) {
    if (n < -0.2)
        discard;
    return n;
}

void main() {
    o_color = vec4(pick(costly(v_position)), v_uv, 1.0);
}
