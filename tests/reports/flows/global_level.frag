#version 330
// SC315: a texture coordinate (implicit level of detail) through a global.
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

vec2 place;
vec3 look() { return texture(u_map, place).rgb; }

void main() {
    place = vec2(costly(v_position), v_uv.y);
    o_color = vec4(look(), 1.0);
}
