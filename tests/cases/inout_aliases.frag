#version 330
// One variable as in and inout argument, parts of one vector; parameters that are scratch space.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

float swap_add(inout float a, inout float b) {
    float t = wave(vec3(a, b, a));
    a = b + t;
    b = t * 0.5;
    return a - b;
}

void twice(in float x, inout float y) {
    x *= 2.0;
    y += wave(vec3(x));
    x += y;
    y *= x;
}

void main() {
    float a = wave(v_position), b = wave(v_normal);
    float r = swap_add(a, b);
    float s = 0.25;
    twice(s, s);
    r += swap_add(b, a) + s;
    vec3 v = v_normal;
    twice(v.x, v.y);
    twice(a, v.z);
    v.xz *= wave(v);
    o_color = vec4(v * 0.3, r) * 0.3 + vec4(a, b, s, 0.0);
}
