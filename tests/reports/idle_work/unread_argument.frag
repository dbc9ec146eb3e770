#version 330
// A value inside an argument of a parameter that the other value does not need.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

vec3 tint(vec3 p, float by) { return sin(p * 3.0) * by + cos(p.yzx); }

vec3 paint(vec3 p, float by) { return tint(p * 2.0, by) + wave(p); }

void main() {
    vec3 a = tint(v_position, wave(v_normal));
    if (tint(v_normal, wave(v_position.zyx)).x > 0.3)
        a = a.yzx;
    a += paint(v_normal, wave(v_normal * 2.0) + wave(v_position * 2.0));
    o_color = vec4(a * 0.3, 1.0);
}
