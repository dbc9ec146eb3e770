// MUST: laws 2 to 4 hold: zeros that are written as whole numbers
#version 330
uniform vec2 u_resolution;
out vec4 c;
const int NONE = 0;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    float s = sin(exp(p.x) * 9.0);
    float none = 0;
    vec4 zeros = vec4(1, 0, float(NONE), none) * s;
    float bad = acos(p.y * 2.0);
    c = zeros * bad + 0.25;
}
