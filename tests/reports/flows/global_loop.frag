#version 330
// SC315: a loop hands it on from trip to trip.
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
    float n = costly(v_position);
    float edge = 0.0;
    level = v_uv.x;
    for (int i = 0; i < 3; i++) {
        edge += slope();
        level = n * float(i);
    }
    o_color = vec4(edge, v_uv, 1.0);
}
