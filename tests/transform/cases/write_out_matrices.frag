#version 330
uniform float u_a;
in vec3 v_a;
out vec4 color;

//// Arithmetic on matrices is written out before it is made precise.
uniform mat3 u_m;
void main() {
    mat3 m = u_m * 2.0;
    vec3 a = m * (v_a * 2.0) + 3.0 * v_a;
    a *= inverse(m + u_m);
    color = vec4(a, 1.0);
}
//// becomes
#version 400

uniform float u_a;
invariant in vec3 v_a;
precise out vec4 color;
uniform mat3 u_m;

mat3 sc_mat3_plus_mat3(mat3 a, mat3 b) {
    precise mat3 sc_exact_1 = mat3(a[0] + b[0], a[1] + b[1], a[2] + b[2]);
    return sc_exact_1;
}

mat3 sc_mat3_times_float(mat3 a, float b) {
    precise mat3 sc_exact_1 = mat3(a[0] * b, a[1] * b, a[2] * b);
    return sc_exact_1;
}

vec3 sc_mat3_times_vec3(mat3 a, vec3 b) {
    precise vec3 sc_exact_1 = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return sc_exact_1;
}

vec3 sc_vec3_times_mat3(vec3 a, mat3 b) {
    precise vec3 sc_exact_1 = vec3(a[0] * b[0][0] + a[1] * b[0][1] + a[2] * b[0][2], a[0] * b[1][0] + a[1] * b[1][1] + a[2] * b[1][2], a[0] * b[2][0] + a[1] * b[2][1] + a[2] * b[2][2]);
    return sc_exact_1;
}

void main() {
    precise mat3 m = sc_mat3_times_float(u_m, 2.0);
    precise vec3 sc_exact_1 = v_a * 2.0;
    precise vec3 a = sc_mat3_times_vec3(m, sc_exact_1) + 3.0 * v_a;
    precise mat3 sc_exact_2 = sc_mat3_plus_mat3(m, u_m);
    precise mat3 sc_exact_3 = inverse(sc_exact_2);
    a = sc_vec3_times_mat3(a, sc_exact_3);
    color = vec4(a, 1.0);
}

//// Products of all sorts.
uniform mat2x3 u_b;
uniform mat3x2 u_c;
uniform mat3 u_m;
void main() {
    mat3 p = u_b * u_c;
    vec2 q = u_c * v_a;
    vec2 r = v_a * u_b;
    mat2 s = u_c * u_b / 2.0;
    int i = 0;
    p *= p;
    p -= u_m;
    p[i] *= u_m;
    color = vec4(q + r + s[0], p[0].xy);
}
//// becomes
#version 400

uniform float u_a;
invariant in vec3 v_a;
precise out vec4 color;
uniform mat2x3 u_b;
uniform mat3x2 u_c;
uniform mat3 u_m;

mat2 sc_mat2_over_float(mat2 a, float b) {
    precise mat2 sc_exact_1 = mat2(a[0] / b, a[1] / b);
    return sc_exact_1;
}

mat3 sc_mat2x3_times_mat3x2(mat2x3 a, mat3x2 b) {
    precise mat3 sc_exact_1 = mat3(a[0] * b[0][0] + a[1] * b[0][1], a[0] * b[1][0] + a[1] * b[1][1], a[0] * b[2][0] + a[1] * b[2][1]);
    return sc_exact_1;
}

mat3 sc_mat3_minus_mat3(mat3 a, mat3 b) {
    precise mat3 sc_exact_1 = mat3(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    return sc_exact_1;
}

mat3 sc_mat3_times_mat3(mat3 a, mat3 b) {
    precise mat3 sc_exact_1 = mat3(a[0] * b[0][0] + a[1] * b[0][1] + a[2] * b[0][2], a[0] * b[1][0] + a[1] * b[1][1] + a[2] * b[1][2], a[0] * b[2][0] + a[1] * b[2][1] + a[2] * b[2][2]);
    return sc_exact_1;
}

mat2 sc_mat3x2_times_mat2x3(mat3x2 a, mat2x3 b) {
    precise mat2 sc_exact_1 = mat2(a[0] * b[0][0] + a[1] * b[0][1] + a[2] * b[0][2], a[0] * b[1][0] + a[1] * b[1][1] + a[2] * b[1][2]);
    return sc_exact_1;
}

vec2 sc_mat3x2_times_vec3(mat3x2 a, vec3 b) {
    precise vec2 sc_exact_1 = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return sc_exact_1;
}

vec2 sc_vec3_times_mat2x3(vec3 a, mat2x3 b) {
    precise vec2 sc_exact_1 = vec2(a[0] * b[0][0] + a[1] * b[0][1] + a[2] * b[0][2], a[0] * b[1][0] + a[1] * b[1][1] + a[2] * b[1][2]);
    return sc_exact_1;
}

vec3 sc_vec3_times_mat3(vec3 a, mat3 b) {
    precise vec3 sc_exact_1 = vec3(a[0] * b[0][0] + a[1] * b[0][1] + a[2] * b[0][2], a[0] * b[1][0] + a[1] * b[1][1] + a[2] * b[1][2], a[0] * b[2][0] + a[1] * b[2][1] + a[2] * b[2][2]);
    return sc_exact_1;
}

void main() {
    precise mat3 p = sc_mat2x3_times_mat3x2(u_b, u_c);
    precise vec2 q = sc_mat3x2_times_vec3(u_c, v_a);
    precise vec2 r = sc_vec3_times_mat2x3(v_a, u_b);
    precise mat2 sc_exact_1 = sc_mat3x2_times_mat2x3(u_c, u_b);
    precise mat2 s = sc_mat2_over_float(sc_exact_1, 2.0);
    precise int i = 0;
    p = sc_mat3_times_mat3(p, p);
    p = sc_mat3_minus_mat3(p, u_m);
    precise vec3 sc_exact_2 = p[i];
    p[i] = sc_vec3_times_mat3(sc_exact_2, u_m);
    color = vec4(q + r + s[0], p[0].xy);
}
