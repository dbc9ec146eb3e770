#version 330
// Arguments that change what their neighbours read must be evaluated where they stand.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

int count;

float next() {
    count += 3;
    return float(count % 7) * 0.1;
}

float noisy(vec3 p) { return wave(p) + next(); }

float both(vec3 p, float one, float other) { return wave(p * (1.0 + other)) + one; }

void move(inout vec3 p, float by) { p += wave(p.zxy); p *= 0.9 + 0.1 * by; }

void main() {
    count = int(v_uv.x * 5.0);
    vec3 p = v_position;
    float a = both(p, noisy(v_normal), next());
    move(p, noisy(p));
    float b = both(p * next(), noisy(p), noisy(v_position));
    o_color = vec4(a, b, p.x + next(), 1.0) * 0.4;
}
