#version 330
in vec3 v_position;
uniform float u_a;
out vec4 o_color;
float slope(float x) {
    return fwidth(x);
}
void main() {
    float edge = 0.0;
    if (u_a < 2.0) {
        float n = sin(exp(v_position.x) * 3.0);
        edge = slope(n);
    }
    o_color = vec4(edge, v_position.xy, 1.0);
}
