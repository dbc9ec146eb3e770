#version 330
// Comma expressions, in statements, arguments, conditions and loops.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void main() {
    float a, b = 0.5;
    a = wave(v_position), b += a * wave(v_normal);
    float c = (a += 0.25, wave(v_position * 2.0) * a);
    float d = wave((b *= 2.0, v_normal * b));
    for (int i = 0; i < 3; i++, b += 0.125)
        d += b;
    if (a -= 0.1, a > 0.2)
        c += 0.5;
    o_color = (d = max(d, 0.1), vec4(a, b, c, wave(vec3(d, c, b))));
}
