// Integers, a boolean and numbers that are not finite lie in one texel of unsigned integers.
#version 330
uniform vec2 u_resolution;
struct Hit { float way; int steps; bool found; };
out vec4 o_color;
Hit march(vec2 p) {
    float way = asin(3.0 * p.x) / floor(2.0 * p.y);
    return Hit(way, int(40.0 * p.x) - 20, p.y > 0.3);
}
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    Hit hit = march(p);
    float fog = clamp(hit.way, 0.0, 1.0);
    o_color = vec4(hit.found ? fog : 0.5, float(hit.steps) / 20.0, isnan(hit.way) ? 1.0 : 0.0, 1.0);
}
