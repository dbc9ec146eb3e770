// The payload is infinite along an edge; only a comparison sees that, and a branch swallows it.
#version 330
uniform vec2 u_resolution;
out vec4 o_color;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    float far = exp(2.0 * p.y) / floor(4.0 * p.x);
    vec3 color = vec3(p, 0.5);
    if (far == 2.0 * far) {
        color = color.zxy;
    } else {
        color *= sin(far);
    }
    o_color = vec4(color, 1.0);
}
