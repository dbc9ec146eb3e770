#version 330
// A function that changes a global, called from arguments, conditions and other functions.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

int seed;

float random() {
    seed = seed * 1103515245 + 12345 & 0x7fffffff;
    return float(seed) / 2147483647.0;
}

float noisy(vec3 p) {
    return wave(p) + random() * 0.25;
}

float sum(float a, float b, float c) {
    return a + b * 2.0 + c * 4.0;
}

void step_by(inout vec3 p, float by) {
    p += by * wave(p);
}

void main() {
    seed = int(v_uv.x * 7.0) + 3;
    float a = sum(noisy(v_position), noisy(v_normal), wave(v_position));
    vec3 p = v_position;
    step_by(p, wave(p));
    step_by(p, noisy(p));
    p *= p.x > 0.2 ? wave(p) : 0.5;
    p += p.y > 0.1 && wave(p.zyx) > 0.0 ? vec3(random()) : vec3(0.1);
    a -= random();
    a = a += 0.5;
    o_color = vec4(p * 0.2, a * 0.2) + 0.3;
}
