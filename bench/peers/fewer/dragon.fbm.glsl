// Two octaves of five.
vec3 fbm(vec3 p) {
    p += 0.2 * sin(1.7 * p.zxy);
    return noise(p) + 0.5 * noise(p * 2.02);
}
