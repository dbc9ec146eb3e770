#version 330
// A switch with fall-through, a default in the middle, and returns.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float kind(int which, vec3 p) {
    float value = wave(p);
    switch (which) {
        case 0:
            value += wave(p * 2.0);
        case 1:
            value *= 0.5;
            break;
        default:
            value -= 0.125;
        case 2:
            return value + wave(p.zyx);
    }
    return value * wave(p * 3.0);
}

void main() {
    int which = int(v_uv.x * 3.999);
    float a = kind(which, v_position);
    float b = kind(1, v_normal) * a;
    float c = 0.25;
    switch (int(wave(v_normal) * 2.0)) {
        case 1: c = wave(v_position); break;
        case 0: { c = a; }
    }
    o_color = vec4(a, b, c, 1.0);
}
