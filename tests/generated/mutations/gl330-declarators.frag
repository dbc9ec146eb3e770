#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    float a = sin(v_position.x * 3.0), b = cos(a * v_normal.y + 1.0), c = a * b;
    o_color = vec4(a, b, c, 1.0);
}
