#version 100
#extension GL_OES_standard_derivatives : enable
// GLSL ES 1.00 with everything in mediump, as on telephones.
precision mediump float;

uniform sampler2D texture;
uniform float time;
varying highp vec2 uv;
varying vec3 n;

float wave(vec2 p, float t) {
    float s = 0.0;
    for (int i = 0; i < 5; i++) {
        s += sin(p.x * float(i) + t) * cos(p.y);
    }
    return s;
}

void main() {
    vec4 c = texture2D(texture, uv);
    float k = wave(uv * 7.0, time) + wave(uv * 9.0, 2.0);
    vec3 l = normalize(n) * k;
    gl_FragData[0] = vec4(l * c.rgb, 1.0);
}
