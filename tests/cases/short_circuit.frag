#version 330
// && and || whose right side has a value and a side effect.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float count = 0.0;

bool test(float x) { count += 1.0; return x > 0.1; }

void main() {
    bool a = v_uv.x > 0.4 && wave(v_position) > 0.0;
    bool b = v_uv.y > 0.4 || test(wave(v_normal));
    bool c = test(v_uv.x) && test(wave(v_position * 2.0)) ^^ a;
    float d = wave(v_position * 3.0) + (a ? 1.0 : 0.0);
    o_color = vec4(d, b ? 1.0 : 0.25, c ? 1.0 : 0.5, 1.0) * wave(v_normal) + count;
}
