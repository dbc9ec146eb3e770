#version 310 es
// GLSL ES 3.10 without a default precision of floats.
precision lowp sampler2D;

uniform sampler2D picture;
uniform highp float time;
in mediump vec2 uv;
in mediump vec3 n;
layout(location = 0) out lowp vec4 color;

struct Layer {
    mediump float weight;
    highp vec2 place;
};

mediump float wave(Layer layer, highp float t) {
    mediump float s = 0.0;
    for (int i = 0; i < 4; i++) {
        s += sin(layer.place.x * float(i) + t) * cos(layer.place.y);
    }
    return s * layer.weight;
}

void main() {
    Layer layer = Layer(0.75, uv * 5.0);
    mediump float k = wave(layer, time);
    lowp vec3 tint = vec3(0.9, 0.7, 0.5) * abs(k);
    mediump mat3 turn = mat3(vec3(0.0, 1.0, 0.0), vec3(-1.0, 0.0, 0.0), vec3(0.0, 0.0, 1.0));
    mediump vec3 l = turn * normalize(n) + k;
    color = vec4(l * tint, 1.0);
}
