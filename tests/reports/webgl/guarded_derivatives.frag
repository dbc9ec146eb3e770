#extension GL_OES_standard_derivatives : enable
#ifdef GL_ES
precision highp float;
#endif
uniform vec2 u_resolution;
uniform sampler2D u_map;
void main() { vec2 st = gl_FragCoord.xy / u_resolution; gl_FragColor = vec4(exp(sin(st.xyx * 9.0)) + fwidth(st.x), 1.0) * texture2D(u_map, st); }
