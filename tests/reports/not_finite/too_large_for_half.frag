// A payload from 10,000 to 110,000, as a light has that is not tone-mapped yet.
#version 330
uniform vec2 u_resolution;
out vec4 o_color;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    float light = 1e4 + 1e5 * sin(1.5 * p.x) * sin(1.5 * p.y);
    o_color = vec4(light / (light + 3e4), p, 1.0);
}
