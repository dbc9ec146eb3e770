#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif
#define LEVELS 3
uniform float time;
uniform vec2 resolution;

void main() {
    vec2 uv = gl_FragCoord.xy / resolution;
    float sum = 0.0;
    for (int i = 0; i < LEVELS; i++) {
        sum += exp(sin(uv.x * float(i) + time));
    }
    gl_FragColor = vec4(exp(sin(uv * 9.0 + sum)), sum, 1.0);
}
