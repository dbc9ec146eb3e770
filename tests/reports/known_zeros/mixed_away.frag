// MUST: laws 2 to 4 hold: mix with a weight of zero, and a value that is infinite
#version 330
uniform vec2 u_resolution;
out vec4 c;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    vec2 weight = vec2(0.0, 0.5) * sin(exp(p.x) * 9.0);
    vec2 far = vec2(exp(p.y * 200.0), 2.0);
    vec2 mixed = mix(vec2(0.5), far, weight);
    c = vec4(mixed, dot(weight, far), 1.0);
}
