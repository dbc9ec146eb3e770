// What fits of four texels, blended.

void sc_AMONG(vec4 weights, float total) {
    weights /= total;
}
