// MUST: laws 2 to 4 hold: a zero with a sign, and a choice between zeros
#version 330
uniform vec2 u_resolution;
out vec4 c;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    float s = sin(exp(p.x) * 9.0);
    vec2 zeros = vec2(-0.0, s > 0.0 ? 0.0 : 1.0);
    vec2 tint = zeros * s;
    float far = exp(p.y * 200.0);
    c = vec4(tint * far, 1.0 / tint.x, 1.0);
}
