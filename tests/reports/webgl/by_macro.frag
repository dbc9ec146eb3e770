#define MEDIUM mediump
uniform MEDIUM vec2 resolution;
uniform highp float time;

void main() {
    MEDIUM vec2 uv = gl_FragCoord.xy / resolution;
    gl_FragColor = vec4(exp(sin(uv.xyx * 9.0 + time)), 1.0);
}
