#ifdef GL_ES
precision mediump float;
#endif
uniform sampler2D u;
void main() { gl_FragColor = gl_Color * texture2D(u, gl_TexCoord[0].st) * exp(gl_Color.x); }
