#version 330
// Texture fetches with implicit level of detail under conditions, and beside them.
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
    vec3 base = vec3(0.1);
    float k = noise(floor(p * 4.0));
    if (sin(frame) * p.y > -0.2) {
        base = texture(picture, uv * 3.0).rgb * noise(floor(p * 5.0));
        base += noise(floor(p * 8.0)) * n;
    }
    vec4 other = texture(picture, uv * 2.0);
    color = vec4(base * other.rgb + k * 0.2, 1.0);
}
