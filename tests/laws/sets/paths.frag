#version 330
// Values on several call paths, in arguments of each other's calls, and in one statement.
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
    float rough = noise(floor(q * 6.0)) * 0.5;
    return sin(q.y * 4.0 + rough) + rough * noise(floor(q * 9.0));
}
float grain(float a, vec3 q) {
    float fine = a * noise(floor(q * 7.0));
    return a + fine;
}
vec3 paint(vec3 q, float light) {
    vec3 base = vec3(marble(q * 2.0), noise(floor(q * 3.0)), 0.4);
    return base * light;
}
void main() {
    float both = marble(p) + marble(n);
    {
        both += grain(noise(floor(n * 5.0)), p) * 0.3;
    }
    float deep = grain(marble(p.zxy), n.yzx);
    vec3 painted = paint(p, both) + paint(n, noise(floor(p * 4.0)) + deep);
    color = vec4(painted * 0.3 + texture(picture, uv).rgb * 0.1, 1.0);
}
