#version 330
// The value decides whether its own pixel is discarded, in a function.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void cut(float x) {
    if (x < -0.4)
        discard;
}

void main() {
    float a = wave(v_position);
    cut(a);
    float b = wave(v_normal * 2.0);
    o_color = vec4(a, b, a * b + 0.5, 1.0);
}
