#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    float c = 0.5;
    float b = (c = sin(exp(v_position.x) * 3.0)) + v_normal.y;
    o_color = vec4(b, c, v_normal.xy);
}
