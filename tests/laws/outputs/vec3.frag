#version 330 core
// A colour without alpha.

in vec3 p;
in vec3 n;

out vec3 o_color;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void main() {
    o_color = vec3(0.5) + 0.4 * noise(p) * n;
}
