#version 330 core
// A number, an identity and a colour, one behind a discard.

in vec3 p;
in vec3 n;

layout(location = 0) out uvec2 o_id;
layout(location = 1) out float o_depth;
layout(location = 2) out vec4 o_color;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void main() {
    float grain = noise(p);
    o_id = uvec2(7u, uint(4.0 + 3.0 * grain));
    if (sin(7.0 * n.x) > 0.8) {
        discard;
    }
    o_depth = 0.1 * p.z + 0.01 * grain;
    o_color = vec4(vec3(0.5 + 0.5 * grain * n.x), 1.0);
}
