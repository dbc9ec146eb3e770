#version 450
// OpenGL takes it as well as Vulkan: everything has a place.
layout(location = 0) in vec3 v_position;
layout(location = 1) in vec3 v_normal;
layout(location = 2) in vec2 v_uv;
layout(location = 0) out vec4 o_color;
layout(location = 1) out vec2 o_other;
layout(set = 0, binding = 0, std140) uniform Light {
    vec4 u_light;
    float u_strength;
};
layout(set = 0, binding = 2) uniform sampler2D u_detail;

float noise(vec3 at) {
    float sum = 0.0;
    for (int i = 0; i < 4; i++) {
        sum += sin(at.x * 7.0 + float(i)) * sin(at.y * 5.0) * cos(at.z * 9.0);
    }
    return exp(sum);
}

void main() {
    float veins = noise(v_position) + pow(noise(v_position.zxy), 1.7);
    vec3 normal = normalize(v_normal);
    float lit = max(dot(normal, normalize(u_light.xyz - v_position)), 0.0) * u_strength;
    vec3 albedo = texture(u_detail, v_uv).rgb;
    vec3 mixed = albedo * veins + sin(veins * normal) * cos(normal.zxy * 3.0);
    o_color = vec4(mixed * lit, 1.0);
    o_other = normal.xy * veins;
}
