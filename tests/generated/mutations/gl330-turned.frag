#version 330
in vec3 v_position;
out vec4 o_color;
void main() {
    mat2 m = mat2(sin(v_position.xy), cos(v_position.zx)) * 2.1;
    mat2 n = m * 3.3;
    o_color = vec4(n[0], n[1]);
}
