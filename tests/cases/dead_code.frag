#version 330
// Values that nobody uses, in branches never taken and behind a return.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float unused(vec3 p) { return wave(p * 9.0); }

float half_used(vec3 p, float extra) { float gone = wave(p * extra); return wave(p); gone = 1.0; }

void main() {
    float nothing = wave(v_position * 8.0);
    float a = half_used(v_position, wave(v_normal));
    if (false)
        a += unused(v_normal);
    wave(v_position);
    v_uv;
    a + 1.0;
    o_color = vec4(a, wave(v_normal) * a, 0.5, 1.0);
}
