#version 450
#extension GL_EXT_nonuniform_qualifier : require
// Materials by descriptor indexing, lights counted by a specialisation constant.
layout(constant_id = 0) const int LIGHTS = 4;
layout(constant_id = 1) const float EXPOSURE = 1.5;
layout(constant_id = 2) const bool WITH_VEINS = true;

layout(location = 0) in Surface {
    vec3 position;
    vec3 normal;
    vec2 uv;
} surface;
layout(location = 3) flat in uint v_material;
layout(location = 0) out vec4 o_color;

layout(set = 0, binding = 0, std140) uniform Frame {
    mat4 view_projection;
    vec4 eye;
    vec4 light;
} frame;
layout(set = 0, binding = 1, std140) uniform Lights {
    vec4 positions[LIGHTS];
} lights;
layout(set = 2, binding = 0) uniform sampler u_linear;
layout(set = 2, binding = 1) uniform samplerShadow u_compare;
layout(set = 2, binding = 2) uniform texture2D u_textures[];
layout(set = 3, binding = 0) uniform texture2DArray u_shadows;
layout(set = 3, binding = 1) uniform utexture2D u_ids;
layout(set = 3, binding = 2) uniform sampler2D u_noise;
layout(push_constant) uniform Draw {
    uint first;
    float time;
} draw;

vec3 sampled(texture2D from, sampler how, vec2 uv) {
    return texture(sampler2D(from, how), uv).rgb;
}

float veins(vec3 at) {
#ifdef VULKAN
    return exp(sin(at.x * 7.0) * sin(at.y * 5.0) * cos(at.z * 9.0));
#else
    return 0.0;
#endif
}

void main() {
    vec3 n = normalize(surface.normal);
    vec3 lit = vec3(0.0);
    float weights[LIGHTS + 1];
    for (int i = 0; i < LIGHTS; i++) {
        weights[i] = max(dot(n, normalize(lights.positions[i].xyz - surface.position)), 0.0);
        lit += vec3(weights[i]);
    }
    vec3 albedo = sampled(u_textures[nonuniformEXT(v_material)], u_linear, surface.uv);
    float shadow = texture(sampler2DArrayShadow(u_shadows, u_compare), vec4(surface.uv, 0.0, 0.5));
    uint id = textureLod(usampler2D(u_ids, u_linear), surface.uv, 0.0).x;
    float vein = WITH_VEINS ? veins(surface.position) : 1.0;
    float grain = textureLod(u_noise, surface.uv, 0.0).x + pow(vein, 1.7) * float(id & 3u);
    o_color = vec4(albedo * lit * shadow * grain * sin(EXPOSURE) + draw.time, 1.0);
}
