#version 330
// SC424: an initialiser changes another global.
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

float sum = 0.1;

float add() {
    sum += v_uv.x;
    return sum;
}

float unused = add();

void main() {
    o_color = vec4(costly(v_position), v_uv, sum);
}
