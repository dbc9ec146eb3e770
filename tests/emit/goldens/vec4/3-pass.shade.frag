#version 330
// shadercache: 3-pass.shade, node main.11-ff053a83

uniform sampler2D sc_payloads; // what this frame has stored so far
uniform sampler2D sc_payloads_2;
vec4 sc_payload;
in vec3 v_normal;
layout(location = 0) out vec4 o_color;

void sc_shade() {
    vec4 it = sc_payload;
    o_color = vec4(0.5 + 0.5 * (it.xyz * it.w) * normalize(v_normal).z, 1.0);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    vec4 sc_texel = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0);
    vec4 sc_texel_2 = texelFetch(sc_payloads_2, ivec2(gl_FragCoord.xy), 0);
    sc_payload = vec4(sc_texel.xyz, sc_texel_2.x);
    sc_shade();
}
