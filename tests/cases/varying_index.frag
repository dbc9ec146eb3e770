#version 330
// Arrays read and written at an index that differs from pixel to pixel.
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
    int at = int(v_uv.x * 3.999);
    float table[4] = float[4](wave(v_position), wave(v_normal), 0.25, u_time);
    float a = table[at];
    table[(at + 1) % 4] = wave(v_position * 2.0) * a;
    table[at] += 1.0;
    vec3 n = v_normal;
    n[at % 3] = wave(v_normal * 3.0);
    o_color = vec4(a, table[1], table[at] * wave(n), n[at % 3]);
}
