// The inverse of a matrix that is singular in a part of the picture.
#version 330
uniform vec2 u_resolution;
out vec4 o_color;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    float part = max(floor(3.0 * p.x), 0.0);
    mat2 turned = inverse(mat2(part, sin(p.y), 0.0, cos(p.y)));
    vec2 seen = turned * (p + 1.0);
    o_color = vec4(mix(vec2(0.3), seen, lessThan(abs(seen), vec2(4.0))), p.y, 1.0);
}
