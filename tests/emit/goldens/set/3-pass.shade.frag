#version 330
// shadercache: 3-pass.shade, node stone.1-ae098caa, node stone.27-f6bd6cd8

uniform sampler2D sc_payloads; // what this frame has stored so far
uniform sampler2D sc_payloads_2;
float sc_payload_1;
vec3 sc_payload_2;
uniform sampler2D u_map;
uniform vec3 u_tint;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
layout(location = 0) out vec4 o_color;

float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}

vec3 sc_stone(vec3 p) {
    float octaves = sc_payload_1 + 0.25 * noise(p * 4.0);
    return mix(vec3(0.2), vec3(0.9), octaves) * sc_payload_2;
}

void sc_shade() {
    vec3 normal = normalize(v_normal);
    vec3 albedo = sc_stone(v_position);
    float light = max(dot(normal, u_tint), 0.0);
    o_color = vec4(albedo * light + texture(u_map, v_uv).rgb, 1.0);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    vec4 sc_texel = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0);
    vec4 sc_texel_2 = texelFetch(sc_payloads_2, ivec2(gl_FragCoord.xy), 0);
    sc_payload_1 = sc_texel.x;
    sc_payload_2 = vec3(sc_texel.yz, sc_texel_2.x);
    sc_shade();
}
