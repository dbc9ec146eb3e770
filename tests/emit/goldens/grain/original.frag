#version 330
// shadercache: original, node stone.27-f6bd6cd8

uniform sampler2D u_map;
uniform vec3 u_tint;
uniform float u_time;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}

vec3 stone(vec3 p) {
    float octaves = noise(p) + 0.5 * noise(p * 2.0) + 0.25 * noise(p * 4.0);
    vec4 grain = texture(u_map, p.xy);
    return mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
}

void main() {
    vec3 normal = normalize(v_normal);
    vec3 albedo = stone(v_position);
    float light = max(dot(normal, u_tint), 0.0);
    o_color = vec4(albedo * light + texture(u_map, v_uv).rgb, 1.0);
}
