#version 330 core
// Two numbers.

in vec3 p;
in vec3 n;

out vec2 o_pair;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void main() {
    float grain = noise(p);
    o_pair = vec2(grain * n.z, 0.5 + grain);
}
