// Four bytes in the bits of a float: every kind of NaN, infinities and subnormal numbers among them.
#version 330
uniform vec2 u_resolution;
out vec4 o_color;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    uvec4 bytes = uvec4(vec4(p, 1.0 - p.x, 0.5 + 0.5 * sin(9.0 * p.y)) * 255.0);
    bytes.w = p.y < 0.3 ? 127u : p.y < 0.6 ? 255u : bytes.w;
    float held = uintBitsToFloat(bytes.x | bytes.y << 8 | bytes.z << 16 | bytes.w << 24);
    uint bits = floatBitsToUint(held);
    o_color = vec4(uvec4(bits, bits >> 8, bits >> 16, bits >> 24) & 255u) / 255.0;
}
