#extension GL_EXT_shader_texture_lod : require
#ifdef GL_ES
precision highp float;
#endif
uniform vec2 u_resolution;
uniform sampler2D u_map;
void main() { vec2 st = gl_FragCoord.xy / u_resolution; gl_FragColor = vec4(exp(sin(st.xyx * 9.0)), 1.0) * texture2DLodEXT(u_map, st, 2.0); }
