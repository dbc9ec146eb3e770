// MUST: laws 2 to 4 hold: products of matrices of other sizes, of which one element is read
#version 330
uniform vec2 u_resolution;
out vec4 c;
void main() {
    vec2 p = sin(gl_FragCoord.xy / u_resolution * 4.0);
    mat3x2 a = mat3x2(p, p.yx, exp(p));
    mat2x3 b = mat2x3(p, 1.0, 0.3, p.yx);
    mat2 m = a * b;
    mat3 k = b * a;
    float t = transpose(k)[1].z * 0.7 + (a * vec3(p, 1.0)).y;
    c = vec4(m[1].x, k[2].y, t, 1.0);
}
