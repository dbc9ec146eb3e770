// As files of Shadertoy are: no declarations, no main.
#define TAU 6.28318530718
#define ROTATE(a) mat2(cos(a), -sin(a), sin(a), cos(a))

float noise(vec2 p) {
    vec2 i = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    vec4 h = fract(sin(dot(i, vec2(127.1, 311.7)) + vec4(0.0, 127.1, 311.7, 438.8)) * 43758.5453);
    return mix(mix(h.x, h.y, f.x), mix(h.z, h.w, f.x), f.y);
}

float fbm(vec2 p) {
    float sum = 0.0, weight = 0.5;
    for (int i = 0; i < 5; i++, weight *= 0.5) {
        sum += weight * noise(p);
        p = ROTATE(TAU / 7.0) * p * 2.0;
    }
    return sum;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / min(iResolution.x, iResolution.y);
    vec3 color = 0.5 + 0.5 * cos(iTime + fbm(uv * 3.0 + 0.1 * iTime) * TAU + vec3(0.0, 2.0, 4.0));
    if (iMouse.z > 0.0) {
        color *= texture(iChannel0, uv).rgb + float(iFrame % 2) / iChannelResolution[0].x;
    }
    fragColor = vec4(color, 1.0);
}
