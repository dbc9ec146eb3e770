#version 330
// Out and inout arguments that are elements, columns and swizzles, by indices that change.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

float bump(inout float x, out int n) {
    x += wave(vec3(x));
    n = int(x * 3.0) & 1;
    return x * 0.5;
}

void column(inout vec3 c) {
    c = c.zxy * wave(c);
    c.y -= 0.25;
}

void main() {
    float t[4] = float[4](wave(v_position), 0.2, wave(v_normal), 0.4);
    int i = 0, n = 0;
    float a = bump(t[i++], n);
    a += bump(t[i], n);
    a += bump(t[n + 1], i);
    mat3 m = mat3(v_position, v_normal, v_position * v_normal);
    column(m[1]);
    column(m[n]);
    vec4 q = vec4(a, t[0], t[1], t[2]);
    column(q.wyx);
    a -= bump(q[n], n);
    o_color = vec4(m * q.xyz, a) * 0.2 + vec4(t[i], q.w, float(n), 1.0) * 0.1;
}
