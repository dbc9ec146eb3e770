#version 310 es
// MUST: laws 2 to 4 hold: GLSL ES, where floats have no precision by default
uniform highp vec2 u_resolution;
layout(location = 0) out highp vec4 c;
void main() {
    highp vec2 p = sin(gl_FragCoord.xy / u_resolution * 4.0);
    highp mat2 m = mat2(p, p.yx) * 1.7;
    m *= 2.3;
    c = vec4(m * p, (m * m)[0]);
}
