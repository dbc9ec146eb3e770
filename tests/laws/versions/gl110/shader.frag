// No #version: GLSL 1.10. Names that later versions took: 'texture', 'round', 'smooth', 'sample'.
uniform sampler2D texture;
uniform float time;
varying vec2 uv;
varying vec3 n;

struct Light {
    vec3 smooth;
    float strength;
};

float noise(vec3 p) {
    return fract(sin(dot(p, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
}

float round(float x) {
    return floor(x + 0.5);
}

vec4 sample(sampler2D texture, vec2 uv) {
    return texture2D(texture, uv, 0.0);
}

void main() {
    Light light;
    light.smooth = vec3(0.6, 0.8, 0.0);
    light.strength = 1.5 + time;
    float noise = noise(n + round(uv.x * 8.0)) + round(uv.y * 3.0) * light.strength;
    vec4 base = sample(texture, uv) + texture2DProj(texture, vec3(uv, 2.0));
    vec3 lit = max(dot(normalize(n), light.smooth), 0.0) * base.rgb;
    gl_FragColor = vec4(lit * noise, 1.0);
    gl_FragColor.rgb *= 0.5;
}
