// Only the last of seven numbers, in the second texel, is ever not finite.
#version 330
uniform vec2 u_resolution;
struct Lit { vec3 base; vec4 more; };
out vec4 o_color;
Lit lit(vec2 p) {
    return Lit(sin(vec3(p, p.x * p.y)), vec4(cos(p), sqrt(p.x), log(p.y - 0.5)));
}
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    Lit it = lit(p);
    o_color = vec4(it.base * max(it.more.w, -1.5) + it.more.xyz, 1.0);
}
