#version 330 core
// One number.

in vec3 p;
in vec3 n;

out float o_level;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void main() {
    o_level = 0.5 + 0.4 * noise(p * 2.0) * n.z;
}
