#version 330
// A loop whose step is a call that writes its argument.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float advance(inout float t, float by) { t += by; return t * 0.5; }

bool more(inout float left) { left -= 0.25; return left > 0.0; }

void main() {
    float sum = 0.0;
    float start = wave(v_position);
    float left = 1.0 + v_uv.x;
    for (float t = 0.0; t < 2.0; advance(t, 0.25 + abs(v_uv.y)))
        sum += wave(v_normal + t) * start;
    while (more(left))
        sum += advance(start, 0.125);
    float after = wave(v_position * sum) * left;
    o_color = vec4(sum, start, after, 1.0);
}
