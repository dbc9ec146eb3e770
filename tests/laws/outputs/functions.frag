#version 330 core
// Outputs that functions write and read back.

in vec3 p;
in vec3 n;

layout(location = 0) out vec4 o_color;
layout(location = 1) out vec2 o_motion;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void move(float by) {
    o_motion = vec2(by, noise(p.yzx));
}

float darken(vec3 q) {
    o_color.rgb *= 0.9;
    return noise(q) * o_color.r;
}

void main() {
    o_color = vec4(0.5 + 0.5 * n, 1.0);
    move(0.1 * n.x);
    float grain = darken(p);
    o_color.g = grain;
    o_motion.x += o_color.b * noise(p.zxy);
}
