#version 330
// out and inout parameters: copied out in order, the same variable twice, parts of one.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void split(float x, out float low, out float high) { low = wave(vec3(x)); high = low + 1.0; }

float bump(inout vec3 p, float by) { p.xy += by; return wave(p); }

void both(inout float a, inout float b) { a += 1.0; b *= a; }

void main() {
    float low, high;
    split(v_uv.x, low, high);
    vec3 p = v_position;
    float a = bump(p, low);
    float b = bump(p, a) * 0.5;
    vec3 q = v_normal;
    split(q.x, q.y, q.z);
    float pair[2] = float[2](wave(q), 0.5);
    both(pair[0], pair[1]);
    o_color = vec4(a, b, wave(p) * pair[0], high * pair[1]);
}
