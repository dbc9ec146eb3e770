#version 310 es
precision mediump float;
// GLSL ES for Vulkan on a phone.
layout(location = 0) in vec2 v_uv;
layout(location = 0) out vec4 o_color;
layout(set = 0, binding = 0) uniform mediump sampler2D u_albedo;
layout(set = 0, binding = 1) uniform highp texture2D u_detail;
layout(set = 0, binding = 2) uniform mediump sampler u_how;
layout(set = 1, binding = 0) uniform Tint {
    vec4 tint;
};
void main() {
    vec4 detail = texture(sampler2D(u_detail, u_how), v_uv * 8.0);
    o_color = texture(u_albedo, v_uv) * tint * detail * exp(sin(v_uv.x * 9.0) * cos(v_uv.y * 9.0));
}
