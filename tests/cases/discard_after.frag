#version 330
// The node is computed, and pixels are discarded behind it.
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
    float a = wave(v_position) * 0.5 + 0.5;
    vec3 lit = a * vec3(wave(v_normal), wave(v_normal.zyx), 0.5);
    if (fract(v_uv.x * 7.0) < 0.25)
        discard;
    o_color = vec4(lit * wave(v_position * 2.0), 1.0);
}
