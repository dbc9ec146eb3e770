#version 330
// Outer products and products by component whose parts go on into products.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

void main() {
    mat2 a = outerProduct(v_uv * 1.3, vec2(0.7, 1.1));
    vec2 b = a[1] * 0.3;
    mat2 c = matrixCompMult(mat2(v_uv, v_position.xy), mat2(1.3, 0.7, 0.3, 1.9));
    float d = c[0].x * 1.7 + c[1].y * 0.9;
    mat3x2 e = outerProduct(v_uv, v_normal * 2.1) * 0.3;
    vec2 f = e * v_position;
    o_color = vec4(b, d, f.x * f.y);
}
