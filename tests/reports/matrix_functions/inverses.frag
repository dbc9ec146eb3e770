#version 330
// Inverses and determinants with known components, and what is made of them.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

void main() {
    mat2 a = inverse(mat2(v_uv.x * 1.3 + 1.0, 0.2, 0.1, 2.0));
    vec2 b = a[1] * 0.3 + a[0];
    float c = determinant(mat2(v_uv * 1.3, vec2(0.7, 0.3))) * 1.1;
    mat2 d = inverse(mat2(1.5, v_normal.xy * 0.3, 1.7));
    float e = determinant(mat3(v_position, v_normal * 0.3, vec3(0.3, 0.9, 0.1))) * 2.3;
    o_color = vec4(b * d, c, e);
}
