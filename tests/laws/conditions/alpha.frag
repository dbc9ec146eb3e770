#version 330
// A discard that depends on a value that may be cached.
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
    float alpha = noise(floor(p * 6.0)) + noise(floor(p * 3.0)) * 0.5;
    if (alpha < 0.4) discard;
    color = vec4(n * alpha * noise(floor(n * 5.0)), 1.0);
}
