#version 100
precision highp float;
varying vec2 _uv;
uniform sampler2D from, to;
uniform float progress, ratio, _fromR, _toR;

vec4 getFromColor(vec2 uv) {
    return texture2D(from, 0.5 + (uv - 0.5) * vec2(min(ratio / _fromR, 1.0), min(_fromR / ratio, 1.0)));
}

vec4 getToColor(vec2 uv) {
    return texture2D(to, 0.5 + (uv - 0.5) * vec2(min(ratio / _toR, 1.0), min(_toR / ratio, 1.0)));
}

TRANSITION

void main() {
    gl_FragColor = transition(_uv);
}
