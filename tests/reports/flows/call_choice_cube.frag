#version 330
// SC319: it decides in an expression whether a function is called that looks a cube map up.
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

float look() { return textureLod(u_sky, v_normal, 0.0).x; }

void main() {
    float n = costly(v_position);
    float edge = n > 0.3 ? look() : 0.25;
    o_color = vec4(edge, v_uv, 1.0);
}
