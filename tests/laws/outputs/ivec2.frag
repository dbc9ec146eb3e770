#version 330 core
// Integers alone.

in vec3 p;
in vec3 n;

out ivec2 o_cell;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void main() {
    float grain = noise(p);
    o_cell = ivec2(floor(vec2(grain, grain * n.z) * 70000.0));
}
