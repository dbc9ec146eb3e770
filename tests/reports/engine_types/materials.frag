#version 450
#extension GL_EXT_nonuniform_qualifier : require
// Every material of a scene in one array of textures.
layout(location = 0) in vec3 v_position;
layout(location = 1) flat in nonuniformEXT int v_material;
layout(location = 0) out vec4 o_color;
layout(binding = 2) uniform sampler2D u_textures[16];

vec4 sampled(nonuniformEXT int at, vec2 uv) {
    return textureLod(u_textures[nonuniformEXT(at)], uv, 0.0);
}

void main() {
    nonuniformEXT int detail = v_material + 1;
    vec2 uv = v_position.xy * 0.5 + 0.5;
    vec4 base = sampled(v_material, uv) * textureLod(nonuniformEXT(u_textures[detail]), uv * 9.0, 1.0);
    float veins = exp(sin(v_position.x * 7.0) * sin(v_position.y * 5.0) * cos(v_position.z * 9.0));
    o_color = base * pow(nonuniformEXT(veins), 1.7);
}
