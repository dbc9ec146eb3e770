#ifdef GL_ES
precision highp float;
#endif
varying vec3 v_position;

void main() {
    gl_FragColor = vec4(exp(sin(v_position * 9.0)), 1.0);
}
