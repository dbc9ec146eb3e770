// MUST: laws 2 to 4 hold: matrices divided by numbers and numbers by matrices
#version 330
uniform vec2 u_resolution;
out vec4 c;
void main() {
    vec2 p = sin(gl_FragCoord.xy / u_resolution * 4.0) + 2.0;
    mat2x3 m = mat2x3(p, 1.0, 3.0, p);
    for (float i = 1.0; i < 4.0; i++) { m /= 1.7; m = 2.3 / m; }
    vec2 q = vec2(1.5, p.x) * (m[0].xy / 1.3);
    c = vec4(m[0] * 0.7 * 1.9, q.y);
}
