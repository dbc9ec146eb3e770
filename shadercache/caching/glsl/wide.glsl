// Integers in full precision, for GLSL ES: made unsigned in 16 bits, they would lose their sign.
int sc_wide_1(int value) {
    return value;
}

ivec2 sc_wide_2(ivec2 value) {
    return value;
}

ivec3 sc_wide_3(ivec3 value) {
    return value;
}

ivec4 sc_wide_4(ivec4 value) {
    return value;
}
