// MUST: laws 2 to 4 hold: an element of a constant array is zero
#version 330
uniform vec2 u_resolution;
out vec4 c;
const float WEIGHTS[3] = float[3](0.25, 0.0, 0.5);
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    float s = sin(exp(p.x) * 9.0);
    float first = WEIGHTS[1] * s;
    float bad = pow(p.y - 0.5, 1.5);
    float sum = WEIGHTS[0] * s;
    for (int i = 1; i < 3; i++) { sum += WEIGHTS[i] * s; }
    c = vec4(first * bad, sum, WEIGHTS[1] * bad, 1.0);
}
