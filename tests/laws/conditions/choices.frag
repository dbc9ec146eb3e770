#version 330
// Choices inside expressions: ?:, && and ||, nested.
in vec3 p;
in vec3 n;
in vec2 uv;
uniform float frame;
uniform sampler2D picture;
out vec4 color;

float noise(vec3 q) {
    return fract(sin(dot(q, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
}

void main() {
    bool on = sin(p.y * 9.0 + frame * 0.7) > 0.1;
    float k = on ? noise(floor(p * 6.0)) + noise(floor(p * 13.0)) : n.x;
    float m = uv.x > 0.5 ? (on ? noise(floor(p * 4.0)) * k : noise(floor(n * 4.0))) : 0.5;
    vec3 base = vec3(k, m, 0.2);
    if (on && noise(floor(p * 3.0)) > 0.4) base.z = 1.0;
    else if (!on || uv.y > 0.5 && noise(floor(p * 2.0)) > 0.6) base *= noise(on ? p : n.zyx);
    color = vec4(base * (uv.y < 0.3 ? noise(floor(p * 9.0)) : 1.0), 1.0);
}
