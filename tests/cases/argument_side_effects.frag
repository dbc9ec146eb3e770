#version 330
// Arguments that write what other arguments and later statements read.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float both(float a, float b) { return sin(a) * cos(b * 2.0) + a; }

void main() {
    float x = v_uv.x;
    float y = v_uv.y;
    float a = both(x++, wave(v_position));
    float b = both(y = wave(v_normal) + y, 0.5);
    float c = both(a += 0.25, b) + wave(v_position * 2.0);
    float d = wave(v_normal * x) + wave(v_position * y);
    o_color = vec4(a, b, c, d);
}
