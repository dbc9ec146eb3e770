#version 330
// SC424: an initialiser discards.
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

float kind(float x) {
    if (x > 0.7)
        discard;
    return x * 2.0;
}

float factor = kind(v_uv.x);

void main() {
    o_color = vec4(costly(v_position) * factor, v_uv, 1.0);
}
