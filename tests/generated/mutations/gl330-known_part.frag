#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    vec4 t = vec4(abs(v_position), 0.5);
    o_color = pow(t, vec4(1.5));
}
