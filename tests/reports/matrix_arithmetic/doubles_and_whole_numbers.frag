// MUST: laws 2 to 4 hold: matrices of doubles, and numbers that are whole
#version 400
uniform vec2 u_resolution;
out vec4 c;
void main() {
    vec2 p = sin(gl_FragCoord.xy / u_resolution * 4.0);
    dmat2 wide = dmat2(p, p.yx) * 1.7;
    mat2 m = mat2(p, p.yx) * 3;
    m *= 7;
    vec2 q = m * ivec2(2, 3);
    c = vec4(vec2(wide * dvec2(q)), m[1] * 0.3);
}
