#if defined(GL_ES) || defined(GL_SL)
precision highp float;
precision highp int;
#endif
varying vec2 v;
void main() { gl_FragColor = vec4(exp(sin(v.xyx * 9.0)), 1.0); }
