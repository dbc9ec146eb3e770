// Parked misses, second: a depth for each pixel that waits, by the number of its group; the farthest
// depth for all others.
void main() {
    sc_TEXEL texel = texelFetch(sc_payloads, sc_OWN_TEXEL(), 0);
    bool missed = texel.w == sc_missed_depth;
    // What is not a parked pixel may hold anything, infinities among it.
    float share = missed ? sc_FIRST_MARK + float(texel.x) / sc_MARKS : 1.0;
    gl_FragDepth = mix(gl_FragCoord.z, gl_DepthRange.far, share);
}
