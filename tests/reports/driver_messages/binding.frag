#version 420 core
// A comment, and blank lines,


// that printing may move.
uniform vec2 u_resolution;
layout(binding = 999) uniform sampler2D u_layer;
out vec4 o;
float ripple(vec2 p) { return exp(sin(p.x * 9.0)); }
void main() {
    vec2 uv = gl_FragCoord.xy / u_resolution;
    o = texture(u_layer, uv) * ripple(uv);
}
