#version 330
// Values in initialisers of globals, some of varyings, some written later.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float fixedPart = u_time * 0.5 + 0.25;
vec3 moved = v_position * 2.0 + u_light;
float changed = sin(v_uv.x * 9.0) * cos(v_uv.y * 7.0);

void main() {
    float a = wave(moved) * fixedPart;
    float b = wave(v_normal) + changed;
    changed = a * 0.5;
    o_color = vec4(a, b, wave(v_position) * changed, 1.0);
}
