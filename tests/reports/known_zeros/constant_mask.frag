// MUST: laws 2 to 4 hold: a named constant has a zero component
#version 330
uniform vec2 u_resolution;
out vec4 c;
const vec3 MASK = vec3(1.0, 0.0, 0.5);
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    vec3 tint = MASK * sin(exp(p.x) * 9.0);
    float d = log(p.y - 0.5);
    c = vec4(0.1 + tint * d, 1.0);
}
