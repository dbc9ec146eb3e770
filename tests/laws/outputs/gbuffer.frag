#version 330 core
// Three targets of a deferred renderer, declared in another order than they stand.

in vec3 p;
in vec3 n;

layout(location = 2) out vec4 g_material;
layout(location = 0) out vec4 g_albedo;
layout(location = 1) out vec3 g_normal;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void main() {
    float grain = noise(p);
    vec3 rock = vec3(0.4, 0.35, 0.3) + 0.2 * grain;
    g_normal = normalize(n + 0.1 * grain);
    g_albedo = vec4(rock, 1.0);
    g_material = vec4(rock.x, 0.5, grain, 1.0);
}
