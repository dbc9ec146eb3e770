#version 300 es
// shadercache: original, unchanged

out mediump vec4 legacy_FragColor;

// GLSL ES 1.00 with everything in mediump, as on telephones.
precision mediump float;
uniform sampler2D legacy_texture;
uniform float time;
in highp vec2 uv;
in vec3 n;

float wave(vec2 p, float t) {
    float s = 0.0;
    for (int i = 0; i < 5; i++) {
        s += sin(p.x * float(i) + t) * cos(p.y);
    }
    return s;
}

void main() {
    vec4 c = texture(legacy_texture, uv);
    float k = wave(uv * 7.0, time) + wave(uv * 9.0, 2.0);
    vec3 l = normalize(n) * k;
    legacy_FragColor = vec4(l * c.rgb, 1.0);
}
