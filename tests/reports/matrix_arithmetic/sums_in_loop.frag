// MUST: laws 2 to 4 hold: matrices that are added and taken off in a loop
#version 330
uniform vec2 u_resolution;
out vec4 c;
void main() {
    vec2 p = sin(gl_FragCoord.xy / u_resolution * 4.0);
    mat3 m = mat3(p, 1.0, p.yx, 0.5, 0.25, p);
    vec3 q = vec3(p, 1.0);
    for (int i = 0; i < 5; i++) { m += 1.03; m -= mat3(0.3); q += m[1]; }
    c = vec4(q, m[2][2]);
}
