#version 330
// A switch whose cases fall through.
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
    float s = 0.0;
    switch (int(floor(p.y * 4.0 + frame * 0.25)) & 3) {
    case 0:
        s = noise(floor(p * 5.0)) * 2.0;
    case 1:
        s += noise(floor(p * 7.0)) + noise(floor(n * 3.0));
        break;
    case 2:
        color = vec4(noise(floor(p.zyx * 5.0)));
        return;
    default:
        s = 0.25;
    }
    color = vec4(s, noise(floor(p * 9.0)) * s, 0.5, 1.0);
}
