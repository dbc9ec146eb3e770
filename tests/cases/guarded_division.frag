#version 330
// Divisions, roots and logarithms that only a condition keeps defined.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float safe(float x) { return x == 0.0 ? 0.0 : wave(vec3(1.0 / x)); }

void main() {
    float zero = floor(v_uv.x * 2.0);
    float a = zero > 0.5 ? wave(v_position) / zero : 0.25;
    float b = 0.5;
    if (v_uv.y > 0.5)
        b = sqrt(v_uv.y - 0.5) * wave(v_normal);
    float c = safe(zero) + wave(v_position * 2.0);
    float d = zero == 0.0 || log(zero) >= 0.0 ? c : 0.0;
    o_color = vec4(a, b, c, d);
}
