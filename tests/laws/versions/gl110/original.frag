#version 330 core
// shadercache: original, unchanged

out vec4 legacy_FragColor;

// No #version: GLSL 1.10. Names that later versions took: 'texture', 'round', 'smooth', 'sample'.
uniform sampler2D legacy_texture;
uniform float time;
in vec2 uv;
in vec3 n;

struct Light {
    vec3 legacy_smooth;
    float strength;
};

float noise(vec3 p) {
    return fract(sin(dot(p, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
}

float legacy_round(float x) {
    return floor(x + 0.5);
}

vec4 sample(sampler2D legacy_texture, vec2 uv) {
    return texture(legacy_texture, uv, 0.0);
}

void main() {
    Light light;
    light.legacy_smooth = vec3(0.6, 0.8, 0.0);
    light.strength = 1.5 + time;
    float legacy_noise = noise(n + legacy_round(uv.x * 8.0)) + legacy_round(uv.y * 3.0) * light.strength;
    vec4 base = sample(legacy_texture, uv) + textureProj(legacy_texture, vec3(uv, 2.0));
    vec3 lit = max(dot(normalize(n), light.legacy_smooth), 0.0) * base.rgb;
    legacy_FragColor = vec4(lit * legacy_noise, 1.0);
    legacy_FragColor.rgb *= 0.5;
}
