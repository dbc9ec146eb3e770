#version 330
// Fetches that choose their level of detail behind conditions and in loops.
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


vec3 layer(vec2 at) { return texture(u_map, at).rgb * 0.5 + wave(vec3(at, 0.5)); }

void main() {
    float a = wave(v_position);
    vec3 base = layer(v_uv);
    if (u_time > 0.0)
        base += texture(u_map, v_uv * 2.0).rgb * a;
    if (u_light.x > 0.5) {
        vec3 more = layer(v_uv * 3.0);
        base += more * wave(v_normal);
    }
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 3; i++)
        sum += texture(u_map, v_uv + float(i) * 0.25).rgb;
    float b = wave(v_position * 2.0) + sum.x;
    o_color = vec4(base * b + sum * 0.25, 1.0);
}
