#version 330
// Values under conditions that come and go from frame to frame.
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
    vec3 base = vec3(0.2);
    float wave = sin(p.y * 9.0 + frame * 0.7);
    if (wave > 0.3) {
        float spots = noise(floor(p * 6.0)) + noise(floor(p * 13.0));
        base = mix(base, vec3(0.9, 0.5, 0.1), spots);
    } else if (noise(floor(p * 4.0)) > 0.5) {
        base += abs(n) * noise(p);
    } else
        base = vec3(noise(floor(p * 3.0)) * n.x);
    color = vec4(base, 1.0);
}
