#version 330
// Discards before and behind values, some of which come and go.
in vec3 p;
in vec3 n;
in vec2 uv;
uniform float frame;
uniform sampler2D picture;
out vec4 color;

float noise(vec3 q) {
    return fract(sin(dot(q, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
}

void cut(float x) {
    if (x < 0.2) discard;
}
void main() {
    float early = noise(floor(p * 5.0)) + noise(floor(p * 2.0));
    if (fract(p.y * 3.0 + frame * 0.1) < 0.3) discard;
    float late = noise(floor(p * 7.0)) * early;
    cut(fract(uv.x * 5.0));
    color = vec4(early, late, noise(n) * late, 1.0);
}
