#version 330
// An outer product of what depends on its other side, in a sum that is taken apart.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

mat2 turn(float angle) { return mat2(cos(angle), sin(angle), -sin(angle), cos(angle)); }

void main() {
    mat2 r = turn(v_position.x * 3.1);
    vec2 uv = r * v_uv;
    mat2 m = inverse(r) * turn(0.5) + outerProduct(v_uv, uv);
    mat2 k = outerProduct(uv, v_uv) - matrixCompMult(m, r) * 0.7;
    o_color = vec4(determinant(m), determinant(k) * 1.3, m[0] + k[1] * 0.3);
}
