#version 330
// offered: beside the derivative in its statement.
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

void main() {
    float x = v_uv.x;
    if (u_time < 2.0) {
        x = slope(x) + costly(v_position);
    }
    o_color = vec4(x, v_uv, 1.0);
}
