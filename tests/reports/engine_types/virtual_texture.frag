#version 450
#extension GL_ARB_sparse_texture2 : require
#extension GL_ARB_sparse_texture_clamp : enable
// A texture of which only some pages are in memory: where one is missing, a coarser one is taken.
layout(location = 0) in vec3 v_position;
layout(location = 0) out vec4 o_color;
uniform sampler2D u_pages;
uniform sampler2D u_residency;

vec4 paged(vec2 uv) {
    vec4 texel = vec4(0.0);
    int code = sparseTextureARB(u_pages, uv, texel);
    float least = textureLod(u_residency, uv, 0.0).r * 8.0;
    if (!sparseTexelsResidentARB(code)) {
        code = sparseTextureLodARB(u_pages, uv, least, texel);
    }
    return texel;
}

void main() {
    vec2 uv = v_position.xy * 0.5 + 0.5;
    vec4 base = paged(uv) + textureClampARB(u_pages, uv * 3.0, 2.0);
    float veins = exp(sin(v_position.x * 7.0) * sin(v_position.y * 5.0) * cos(v_position.z * 9.0));
    o_color = base * pow(veins, 1.7);
}
