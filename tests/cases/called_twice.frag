#version 330
// Functions called several times, one call of which is cached.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float fbm(vec3 p) { return wave(p) + 0.5 * wave(p * 2.0) + 0.25 * wave(p * 4.0); }

float twice(vec3 p) { return fbm(p) * fbm(p + 1.0); }

void main() {
    o_color = vec4(twice(v_position), twice(v_normal), fbm(v_position), fbm(vec3(v_uv, 0.5)));
}
