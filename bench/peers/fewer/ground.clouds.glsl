// Two octaves of five.
float clouds(vec2 p) {
    return (noise(p) + 0.5 * noise(2.03 * p + 7.1)) / 1.5;
}
