#version 300 es
precision highp float;
in highp vec3 v_position;
in highp vec3 v_normal;
in highp vec2 v_uv;
out highp vec4 o_color;
bool high(float x) { return fract(x * 3333.3 * 77.7) > 0.5; }
float either(bool x) { return x ? 0.5 : 0.1; }
void main() {
    o_color = vec4(0.0);
    float k = fract(v_position.x * 3.7) * 2.1;
    if (fract(k * 3333.3 * 77.7) > 0.5) o_color.x = 0.5;
    switch (int(fract(k * 3333.3 * 77.7) * 3.0)) {
    case 0:
        float t = fract(k * 3333.3 * 77.7);
        if (t > 0.1) o_color.y = 0.5;
    default:
        break;
    }
    o_color.z += fract(k * 3333.3 * 77.7) > 0.7 ? 0.3 : 0.2;
    if (high(k)) o_color.w += 0.2;
    o_color.w += either(fract(k * 3333.3 * 77.7) > 0.3);
    int i = int(fract(k * 3333.3 * 77.7) * 4.0);
    if (i == 2) o_color.z += 0.3;
    float r = v_uv.x;
    while (r < fract(v_uv.y * 2.1 * 3333.3 * 77.7)) r += 0.3;
    o_color.x += r;
}
