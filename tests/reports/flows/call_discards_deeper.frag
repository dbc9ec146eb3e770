#version 330
// SC316: the call of a call discards.
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

float outer(float n) {
    float m = pick(n) * 2.0;
    return sin(exp(m)) + cos(m);
}

void main() {
    float r = outer(costly(v_position));
    float q = sin(exp(r) * 3.0);
    o_color = vec4(r, q, v_uv);
}
