#version 330
// shadercache: 3-pass.shade, node stone.1-ae098caa

uniform sampler2D sc_payloads; // what this frame has stored so far
float sc_payload;
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
    float octaves = sc_payload + 0.25 * noise(p * 4.0);
    vec4 grain = texture(u_map, p.xy);
    return mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
}

void sc_shade() {
    vec3 normal = normalize(v_normal);
    vec3 albedo = sc_stone(v_position);
    float light = max(dot(normal, u_tint), 0.0);
    o_color = vec4(albedo * light + texture(u_map, v_uv).rgb, 1.0);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    sc_payload = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0).x;
    sc_shade();
}
