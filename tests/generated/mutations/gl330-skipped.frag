#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    o_color = vec4(v_normal, 1.0);
    if (v_normal.x > 0.1) {
        o_color.x = sin(exp(v_position.x) * 3.0);
    }
}
