#version 100
precision highp float;
varying highp vec3 v_position;
varying highp vec3 v_normal;
void main() {
    if (v_normal.y < 0.1) discard;
    float r = 0.0;
    for (int i = 0; i < 2; i++) {
        r += sin(3.0 * v_position.y + pow(fract(r) + 0.5, 1.5));
    }
    gl_FragColor = vec4(0.0, 0.0, 0.2 * fract(r), 1.0);
}
