// MUST: laws 2 to 4 hold: what is beside the diagonal of a matrix is zero
#version 330
uniform vec2 u_resolution;
out vec4 c;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    mat2 scale = mat2(0.5) * sin(exp(p.x) * 9.0);
    vec2 bad = sqrt(p - 0.5);
    c = vec4(scale * bad, scale[0][1], 1.0);
}
