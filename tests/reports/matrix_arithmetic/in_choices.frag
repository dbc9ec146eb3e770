// MUST: laws 2 to 4 hold: products under conditions, in arguments, in results and in elements of arrays
#version 330
uniform vec2 u_resolution;
out vec4 c;
mat2 turn(float a) { return mat2(cos(a), sin(a), -sin(a), cos(a)) * 1.1 * 0.9; }
float first(mat2 m, vec2 v) { return (m * v).x; }
void main() {
    vec2 p = sin(gl_FragCoord.xy / u_resolution * 4.0);
    mat2 all[2];
    all[0] = turn(p.x);
    all[1] = all[0] * all[0];
    for (int i = 0; i < 2; i++) { all[i] *= 1.03; all[i] *= turn(p.y) * 1.7; }
    float a = p.x > 0.2 ? first(all[1] * 2.1, p * 3.3) : (p * all[0]).y;
    c = vec4(a, all[1][0] * 0.3, 1.0);
}
