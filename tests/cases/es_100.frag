#version 100
// GLSL ES 1.00: precisions, loops of constant length, no integers to speak of.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif
varying vec3 v_position;
varying vec3 v_normal;
varying vec2 v_uv;
uniform sampler2D u_map;
uniform float u_time;

lowp float soft(mediump float x) { return clamp(x, 0.0, 1.0); }

float wave(vec3 p) {
    float sum = 0.0;
    for (int i = 0; i < 3; ++i)
        sum += sin(p.x * float(i) + p.y) * cos(p.z);
    return sum;
}

void main() {
    mediump float a = wave(v_position) + u_time;
    lowp vec3 base = texture2D(u_map, v_uv).rgb * soft(a);
    highp float b = wave(v_normal) * a;
    gl_FragColor = vec4(base, 1.0) + vec4(b, soft(b), sin(a * 3.0), 0.0);
}
