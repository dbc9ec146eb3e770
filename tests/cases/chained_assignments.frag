#version 330
// Assignments inside assignments, and ++ where a value is wanted.
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
    float a, b, c;
    a = b = wave(v_position);
    c = (a += wave(v_normal)) * (b -= 0.5);
    int i = 0;
    float t[3];
    t[i++] = wave(v_position * 2.0);
    t[i++] = a;
    t[i] = c = wave(v_normal * 3.0) + c;
    vec2 v = vec2(a++, ++b);
    o_color = vec4(v * t[0], t[1] * wave(vec3(a, b, c)), t[2]);
}
