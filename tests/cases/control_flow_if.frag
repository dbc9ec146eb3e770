#version 330
// Values in and after if and else, which a variable carries out of them.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void main() {
    float a = wave(v_position);
    float b;
    if (a > 0.0) {
        float t = wave(v_normal);
        b = t * a;
        if (v_uv.x > 0.5)
            b += wave(v_position * 2.0);
    } else if (v_uv.y > 0.5)
        b = wave(v_normal * 2.0);
    else
        b = 0.25;
    float c = wave(v_position * 3.0) * b;
    o_color = vec4(a, b, c, 1.0);
}
