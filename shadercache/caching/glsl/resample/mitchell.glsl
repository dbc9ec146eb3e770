// Mitchell and Netravali 1988, with B = C = 1/3.

// The weights of four texels in a row, for a place that lies a part of the way from the second to
// the third. A place right on a texel is that texel.
vec4 sc_kernel(float part) {
    if (part == 0.0) {
        return vec4(0.0, 1.0, 0.0, 0.0);
    }
    vec4 x = vec4(1.0 + part, part, 1.0 - part, 2.0 - part);
    vec2 inner = x.yz;
    vec2 outer = x.xw;
    inner = ((7.0 * inner - 12.0) * inner * inner + 16.0 / 3.0) / 6.0;
    outer = (((-7.0 / 3.0 * outer + 12.0) * outer - 20.0) * outer + 32.0 / 3.0) / 6.0;
    return vec4(outer.x, inner, outer.y);
}
