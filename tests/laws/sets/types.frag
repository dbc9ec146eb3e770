#version 330
// Values of several types, some of them under a condition or behind a discard.
in vec3 p;
in vec3 n;
in vec2 uv;
uniform float frame;
uniform sampler2D picture;
out vec4 color;

struct Spot {
    vec2 place;
    bool bright;
};

float noise(vec3 q) {
    return fract(sin(dot(q, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
}
Spot spot(vec3 q) {
    return Spot(vec2(noise(floor(q * 5.0)), noise(floor(q * 2.0))), noise(floor(q * 3.0)) > 0.4);
}
void main() {
    int cell = int(noise(floor(p * 4.0)) * 9.0);
    Spot found = spot(p);
    mat2 turn = outerProduct(vec2(noise(floor(n * 2.0)), 1.0), vec2(noise(n), 0.5));
    bool lit = noise(floor(n * 6.0)) > 0.3;
    vec3 base = vec3(turn * found.place, float(cell) / 9.0);
    if (fract(p.y * 3.0 + frame * 0.1) < 0.2) discard;
    if (sin(p.x * 5.0 + frame) > 0.0) {
        uint bits = floatBitsToUint(noise(floor(p * 8.0))) >> 20;
        base.y += float(bits & 7u) / 16.0;
    }
    color = vec4(found.bright ? base : base.zxy, lit ? 1.0 : 0.5);
}
