#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    vec4 a = sin(vec4(v_position * 3.0, v_normal.y));
    o_color = a * v_normal.z;
}
