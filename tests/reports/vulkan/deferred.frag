#version 460
#extension GL_EXT_samplerless_texture_functions : require
// A second subpass: what the first one left at the pixel is lit.
layout(input_attachment_index = 0, set = 0, binding = 0) uniform subpassInput u_albedo;
layout(input_attachment_index = 1, set = 0, binding = 1) uniform subpassInputMS u_normal;
layout(set = 0, binding = 2) uniform texture2D u_table;
layout(location = 0) in vec2 v_uv;
layout(location = 0) out vec4 o_color;
layout(push_constant, std430) uniform Light {
    layout(offset = 16) vec3 direction;
    float strength;
} light;

void main() {
    vec4 albedo = subpassLoad(u_albedo);
    vec3 normal = subpassLoad(u_normal, 0).xyz;
    float gloss = texelFetch(u_table, ivec2(v_uv * vec2(textureSize(u_table, 0))), 0).x;
    float lit = pow(max(dot(normal, light.direction), 0.0), gloss * 8.0) * light.strength;
    o_color = albedo * lit + exp(sin(v_uv.x * 40.0) * cos(v_uv.y * 30.0));
}
