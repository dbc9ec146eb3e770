#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void split(vec3 p, out float low, out float high) {
    low = sin(p.x * 3.0);
    high = cos(p.y * 2.0);
}
void main() {
    float a = 0.5, b = 0.25;
    split(v_position, a, b);
    o_color = vec4(a, b, a * v_normal.x, 1.0);
}
