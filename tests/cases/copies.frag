#version 330
// Variables that copy one another and are then changed apart.
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
    float a = wave(v_position);
    float b = a;
    float c = (b);
    a += wave(v_normal);
    b = c;
    float d = a;
    d = d * 2.0;
    vec3 v = vec3(a, b, c);
    vec3 w = v;
    w.x = wave(v);
    float e = wave(v_position) + wave(v_normal);
    float f = (wave(v_position)) + (wave(v_normal));
    o_color = vec4(a * b, c * d, w.x * v.y, e * f);
}
