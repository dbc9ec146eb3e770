#version 330
// Such arguments in arguments of such calls, in a declaration, a return and a condition.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

float mixed(vec3 p, float one, float other) { return exp(-abs(p.x)) + one * other; }

float deep(vec3 p) {
    return mixed(p, mixed(p.yzx, wave(p), wave(p * 2.0)), wave(p * 3.0));
}

void main() {
    float a = deep(v_position), b = deep(v_normal);
    switch (int(mixed(v_normal, wave(v_position), 0.5) * 2.0)) {
    case 0:
        a = mixed(v_position, wave(v_normal.zxy), a);
        break;
    default:
        b = a;
    }
    o_color = vec4(a, b, mixed(v_position, deep(v_normal.zyx), b), 1.0) * 0.4;
}
