#version 330 core
// A bloom pair; the linker has to place it.

in vec3 p;
in vec3 n;

out vec4 o_color;
out vec4 o_bright;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void main() {
    vec3 light = vec3(0.6 + 0.5 * noise(p)) * (0.5 + n.z);
    o_color = vec4(light, 1.0);
    o_bright = vec4(max(light - 0.8, 0.0), 1.0);
}
