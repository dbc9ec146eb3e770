layout(location = 0) out vec4 o_color;
layout(location = 1) out uvec2 o_bits;
layout(location = 2) out int o_level;

void main() {
    float rock = pitted(p);
    o_bits = uvec2(floatBitsToUint(rock), uint(n.z > 0.2));
    o_level = isnan(rock) ? -7 : int(8.0 * rock);
    o_color = vec4(rock);
}
