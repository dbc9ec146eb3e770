/* a header */ // more
#define PI 3.14159
#extension GL_OES_standard_derivatives : enable

precision highp float;
varying vec2 v;
void main() { gl_FragColor = vec4(exp(sin(v.xyx * PI)), fwidth(v.x)); }
