#version 330
// shadercache: 3-pass.shade, node main.11-ff053a83

vec4 sc_payload;
uniform sampler2D sc_payloads;
uniform sampler2D sc_payloads_2;
in vec3 v_normal;
layout(location = 0) out vec4 o_color;

void sc_shade() {
    vec4 it = sc_payload;
    o_color = vec4(0.5 + 0.5 * (it.xyz * it.w) * normalize(v_normal).z, 1.0);
}

void main() {
    vec4 texel = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0);
    vec4 texel_2 = texelFetch(sc_payloads_2, ivec2(gl_FragCoord.xy), 0);
    sc_payload = vec4(texel.xyz, texel_2.x);
    sc_shade();
}
