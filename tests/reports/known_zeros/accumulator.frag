// MUST: laws 2 to 4 hold: a sum that begins with zero and is scaled
#version 330
uniform vec2 u_resolution;
out vec4 c;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    vec3 sum = vec3(0.0);
    float bad = asin(p.x * 2.0);
    float good = cos(exp(p.y) * 5.0);
    for (int i = 0; i < 2; i++) { sum.xy += vec2(good, float(i)) * 0.25; }
    vec3 scaled = sum * good;
    c = vec4(scaled * bad, 1.0);
}
