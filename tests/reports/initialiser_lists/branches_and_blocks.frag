#version 450
struct P { vec3 at; };
in P v;
uniform float u_time;
out vec4 o;

void main() {
    P q = { v.at };
    P r[2] = { q, { sin(v.at) } };
    vec3 c[2][1] = { { { 1, 2, 3 } }, { exp(r[1].at) } };
    if (v.at.x > 0.0) {
        vec2 w = { exp(v.at.x), exp(sin(v.at.y)) };
        o = vec4(w, c[1][0].xy);
    } else if (v.at.x > u_time) {
        vec4 u[1] = { { exp(sin(v.at.x)), v.at.y, u_time, 1.0 } };
        o = u[0] + u_time;
    } else {
        o = vec4(1.0);
    }
}
