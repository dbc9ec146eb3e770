#version 330
// Pixels are discarded before the node is computed.
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
    if (fract(v_uv.y * 5.0) < 0.25)
        discard;
    float a = wave(v_position) * 0.5 + 0.5;
    o_color = vec4(a * wave(v_normal), a, wave(v_position * 2.0) + a, 1.0);
}
