// MUST: laws 2 to 4 hold: a global begins as zero
#version 330
uniform vec2 u_resolution;
out vec4 c;
vec2 offset = vec2(0.0, 1.0);
float wave(float x) { return sin(exp(x) * 9.0); }
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    vec2 shift = offset * wave(p.x);
    float bad = inversesqrt(p.y - 0.5);
    c = vec4(shift * bad, shift.x, 1.0);
}
