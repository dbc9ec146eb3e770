#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    vec3 a = (v_position * 2.1) * 3.3 + (v_normal * 0.7) * 1.9;
    o_color = vec4(a * 1.7, 1.0);
}
