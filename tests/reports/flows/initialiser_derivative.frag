#version 330
// SC312: a global is a derivative from the start.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
uniform sampler2D u_map;
uniform samplerCube u_sky;
out vec4 o_color;

float width = fwidth(v_uv.x);

float costly(vec3 p) {
    return sin(exp(p.x) * 9.0 + width) * cos(exp(p.y) * 7.0);
}

void main() {
    o_color = vec4(costly(v_position), v_uv, 1.0);
}
