// MUST: laws 2 to 4 hold: zeros that a compiler works out
#version 330
uniform vec2 u_resolution;
out vec4 c;
const float ONE = 1.0;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    float s = sin(exp(p.x) * 9.0);
    vec3 zeros = vec3(ONE - 1.0, fract(3.0), step(2.0, 1.0)) * s;
    float bad = log(p.y - 0.5);
    c = vec4(zeros * bad + 0.25, 1.0);
}
