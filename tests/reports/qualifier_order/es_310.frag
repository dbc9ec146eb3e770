#version 310 es
precision highp float;
highp in vec3 v_p;
out mediump vec4 o;

void main() {
    o = vec4(exp(sin(v_p * 7.0)), 1.0);
}
