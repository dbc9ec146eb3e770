#version 330
// Fetches with gradients, of varyings and of values.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
uniform sampler2D u_map;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void main() {
    vec2 dx = dFdx(v_uv);
    vec2 dy = dFdy(v_uv);
    vec4 a = textureGrad(u_map, v_uv, dx, dy);
    vec4 b = textureGrad(u_map, v_uv * 2.0, vec2(0.01, 0.0), vec2(0.0, 0.01));
    float c = wave(v_position);
    vec4 d = textureGrad(u_map, v_uv + c * 0.1, vec2(0.02), vec2(0.03));
    o_color = a * c + b * wave(v_normal) + d;
}
