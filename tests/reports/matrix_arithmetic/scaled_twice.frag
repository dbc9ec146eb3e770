// MUST: laws 2 to 4 hold: a matrix times two numbers, one after the other
#version 330
uniform vec2 u_resolution;
out vec4 c;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    mat2 m = mat2(sin(p.x * 5.0), cos(p.y * 3.0), p) * 2.1;
    mat2 n = m * 3.3;
    c = vec4(n[0], n[1]);
}
