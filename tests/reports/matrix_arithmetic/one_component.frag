// MUST: laws 2 to 4 hold: one component of a product, whose terms Mesa 25 adds in another order
#version 330
uniform vec2 u_resolution;
out vec4 c;
uniform mat4 u_view;
float depth(vec3 p) { return (u_view * vec4(p, 1.0)).w; }
void main() {
    vec2 p = sin(gl_FragCoord.xy / u_resolution * 4.0);
    mat4 turn = mat4(p, 0.3, 0.7, p.yx, 0.1, 0.9, 0.2, p, 0.4, 0.6, 0.5, p);
    vec3 at = exp(vec3(p, 0.37));
    float w = (turn * vec4(at, 1.0)).w;
    float x = (vec4(at, 1.0) * turn).x + depth(at);
    c = vec4(w, x, sin(w) * cos(x), 1.0);
}
