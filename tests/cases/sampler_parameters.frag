#version 330
// Samplers handed to functions.
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


uniform sampler2D u_other;

vec3 blend(sampler2D one, sampler2D other, vec2 at, float by) {
    return mix(texture(one, at).rgb, textureLod(other, at * 2.0, 0.0).rgb, by);
}

vec3 deeper(sampler2D which, vec2 at) { return blend(which, u_other, at, wave(vec3(at, 1.0))); }

void main() {
    vec3 a = deeper(u_map, v_uv);
    vec3 b = deeper(u_other, v_uv.yx);
    o_color = vec4(a * wave(v_position) + b, wave(a));
}
