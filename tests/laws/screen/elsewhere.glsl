// What is interpolated at another place of the pixel.
void main() {
    float centre = wave(interpolateAtCentroid(v_position));
    float beside = wave(interpolateAtOffset(v_position, vec2(0.25)));
    float sampled = wave(interpolateAtSample(v_normal, 0) + dFdx(interpolateAtCentroid(v_normal)));
    o_color = vec4(centre, beside, sampled, wave(v_normal));
}
