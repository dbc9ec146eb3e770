#version 330 core
// An array of outputs between two others.

in vec3 p;
in vec3 n;

layout(location = 1) out vec3 o_layers[3];
layout(location = 0) out vec4 o_color;
layout(location = 4) out int o_last;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void main() {
    for (int layer = 0; layer < 3; layer++) {
        o_layers[layer] = n * float(layer);
    }
    o_layers[1] += vec3(noise(p));
    o_color = vec4(o_layers[1] * 0.25, 1.0);
    o_last = int(8.0 * noise(p.zxy));
}
