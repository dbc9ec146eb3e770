#ifdef GL_ES
precision mediump float;
#endif
uniform vec2 u_resolution;
uniform float u_time;
void main() { vec2 st = gl_FragCoord.xy / u_resolution; gl_FragColor = vec4(exp(sin(st.xyx * 9.0 + u_time)), 1.0); }
