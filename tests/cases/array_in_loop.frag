#version 330
// An array that is written in a loop: llvmpipe gets that wrong behind a discard.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float[3] spread(vec3 p) { return float[3](wave(p), wave(p * 2.0), wave(p.zxy)); }

float sum(float values[3]) {
    values[0] *= 0.5;
    return values[0] + values[1] * values[2];
}

void fill(out float values[3], in float with) {
    for (int i = 0; i < values.length(); i++)
        values[i] = with * float(i + 1);
}

void main() {
    float a[3] = spread(v_position);
    float b[] = a;
    b[1] = wave(v_normal);
    float c[3];
    fill(c, sum(b));
    vec3 d = vec3(c[0], c[1], sum(a));
    o_color = vec4(d, wave(d) + sum(spread(v_normal)));
}
