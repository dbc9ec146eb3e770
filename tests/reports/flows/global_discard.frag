#version 330
// SC316: a discard, through a global.
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
void cut() {
    if (level > 0.3) discard;
}

void main() {
    level = costly(v_position);
    cut();
    o_color = vec4(0.5, v_uv, 1.0);
}
