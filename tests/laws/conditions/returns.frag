#version 330
// Values behind early returns, of main and of a function.
in vec3 p;
in vec3 n;
in vec2 uv;
uniform float frame;
uniform sampler2D picture;
out vec4 color;

float noise(vec3 q) {
    return fract(sin(dot(q, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
}

float marble(vec3 q) {
    if (sin(q.y * 8.0 + frame) > 0.4) return 0.1;
    float a = noise(floor(q * 6.0));
    if (a > 0.8) return a;
    return a + noise(floor(q * 11.0)) * 0.5;
}
void main() {
    color = vec4(0.1, 0.2, 0.3, 1.0);
    if (uv.x > 0.9) return;
    float m = marble(p);
    if (m < 0.2) {
        color = vec4(m);
        return;
    }
    vec3 tint = vec3(noise(floor(p * 3.0)), m, marble(n));
    color = vec4(tint * m, 1.0);
}
