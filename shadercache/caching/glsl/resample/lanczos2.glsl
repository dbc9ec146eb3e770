// Lanczos with two lobes: sinc(x) sinc(x / 2).

// The weights of four texels in a row, for a place that lies a part of the way from the second to
// the third. A place right on a texel is that texel.
vec4 sc_kernel(float part) {
    if (part == 0.0) {
        return vec4(0.0, 1.0, 0.0, 0.0);
    }
    vec4 x = vec4(1.0 + part, part, 1.0 - part, 2.0 - part);
    // pi / 2; but for a factor, which the sum of the weights takes away
    x *= 1.5707963267948966;
    vec4 weights = sin(2.0 * x) * sin(x) / (x * x);
    return weights / dot(weights, vec4(1.0));
}
