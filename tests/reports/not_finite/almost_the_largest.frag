// The largest number there is, as one that stands for "nothing was hit", and NaN behind it.
#version 330
uniform vec2 u_resolution;
out vec4 o_color;
float march(vec2 p) {
    float way = p.x < 0.4 ? sqrt(p.y - 0.5) : 3.402823466e38;
    return p.y < 0.3 ? sin(9.0 * p.x) : way;
}
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    float way = march(p);
    o_color = vec4(way == 3.402823466e38 ? 0.75 : max(way, -0.75), p, 1.0);
}
