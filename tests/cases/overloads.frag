#version 330
// Functions of one name, told apart by their arguments; conversions choose one.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float pick(float x) { return sin(x * 3.0) * 0.5 + cos(x); }
float pick(vec2 x) { return cos(x.x * 2.0) * sin(x.y * 5.0); }
float pick(vec3 x) { return pick(x.xy) + pick(x.z); }
float pick(int x) { return float(x) * 0.125; }
float pick(uint x) { return float(x) * 0.25; }
float pick(float x, inout float y) { y += pick(x); return y * pick(vec2(x, y)); }

float both(float a, float b) { return pick(a) * 0.25 + pick(b); }

void main() {
    float a = pick(v_position) + pick(int(v_uv.x * 4.0)) + pick(2u);
    float b = pick(v_uv);
    float c = pick(v_uv.x, b);
    o_color = vec4(a, b, c, both(a, b) + mix(a, c, 0.5));
}
