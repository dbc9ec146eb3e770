#version 330
// SC319: where a cube map is looked up, through a global.
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

vec3 to;
vec3 look() { return textureLod(u_sky, to, 0.0).rgb; }

void main() {
    to = v_normal + costly(v_position);
    o_color = vec4(look(), 1.0);
}
