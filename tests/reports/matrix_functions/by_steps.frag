#version 330
// Matrices that are changed in place, by functions, in a branch and in a loop.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

void grow(inout mat2 m, vec2 by) {
    m *= 1.03;
    m += outerProduct(by, by * 0.7);
}

void main() {
    mat2 m = outerProduct(v_uv, v_position.xy * 1.3);
    grow(m, v_normal.xy);
    if (m[0].x > 0.1)
        m *= 1.1 * mat2(v_uv.x, 0.3, 0.2, v_uv.y);
    vec2 p = m[1] * 0.7;
    for (int i = 0; i < 3; i++) {
        m /= 1.7;
        p += m * p * 0.3;
    }
    o_color = vec4(p, m[0].x * 0.9, m[1].y);
}
