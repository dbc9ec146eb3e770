#version 330 core
// Bits that no float holds.

in vec3 p;
in vec3 n;

out uint o_bits;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void main() {
    float grain = noise(p);
    o_bits = floatBitsToUint(grain) ^ uint(n.z > 0.2);
}
