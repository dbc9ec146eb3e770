// The nearest of those of four texels that fit, alone.

void sc_AMONG(vec4 weights, float total) {
    // Of two that are as near, the first.
    vec4 order = weights * vec4(1.0, 0.9999, 0.9998, 0.9997);
    float most = max(max(order.x, order.y), max(order.z, order.w));
    weights = vec4(equal(order, vec4(most)));
}
