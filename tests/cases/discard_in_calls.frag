#version 330
// Discards in functions that are called before, within and behind values.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

float limit(float x) {
    if (x > 1.35)
        discard;
    return x * 0.5;
}

float deep(vec3 p, inout float sum) {
    float h = wave(p);
    sum += h;
    if (sum < -5.0)
        return limit(h);
    h += limit(v_uv.x + 0.3);
    return h * wave(p + h);
}

void main() {
    float sum = 0.25;
    float a = deep(v_position, sum);
    float b = wave(v_normal) * 0.5;
    b += deep(v_normal, sum);
    float c = limit(v_uv.y);
    c -= wave(v_position * 1.3) * a;
    o_color = vec4(a, b, c, sum) * 0.3 + 0.4;
}
