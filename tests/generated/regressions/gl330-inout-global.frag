#version 330
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform float u_a;
uniform vec3 u_b;
uniform int u_n;
uniform sampler2D u_mipmapped;
uniform sampler2D u_plain;
uniform samplerCube u_cube;
out vec4 o_color;
struct Pair { float first; vec3 second; };
vec2 g0 = vec2(0.5, 0.5);
vec3 f0(inout vec2 a, mat2 b) {
    float c = (v_position.x + 0.5);
    g0.y = (0.5 + 0.5);
    return vec3(0.5, 0.5, 0.5);
}
void main() {
    o_color = vec4(0.0);
    vec3 s = vec3(0.5, 0.5, 0.5) + sin(3.0 * v_position);
    vec4 t = texture(u_mipmapped, vec2(0.5, 0.5)).xxxx * 0.5;
    vec3 a = f0(g0, mat2(1.0));
    float b = 0.5;
    float c = 0.5;
    o_color += t;
    o_color.x += 0.2 * fract(g0.y);
    o_color.x += 0.2 * fract(s.y);
    o_color.x += 0.2 * fract(t.y);
    o_color.x += 0.2 * fract(a.y);
    o_color.x += 0.2 * fract(b);
    o_color.x += 0.2 * fract(c);
}
