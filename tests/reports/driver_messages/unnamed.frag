#version 330 core
// Parameters without names: of a prototype, an array, an out parameter, a struct, and two in a row.
uniform vec2 u_resolution;
out vec4 o;
struct Light { vec3 color; float size; };
float one(float, vec2);
float two(vec2 p, float[2], Light) { return cos(p.y * 3.0); }
void three(out float, in vec2 p, inout vec2 q) { q += sin(p); }
float one(float, vec2 p) { return exp(sin(p.x * 9.0)); }
float four(int, int) { return 0.5; }
void main() {
    vec2 uv = gl_FragCoord.xy / u_resolution;
    float spare;
    three(spare, uv, uv);
    o = vec4(one(1.0, uv) + two(uv, float[2](1.0, 2.0), Light(vec3(1.0), 2.0)) + four(1, 2));
}
