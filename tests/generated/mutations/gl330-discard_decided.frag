#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    float n = sin(exp(v_position.x) * 3.0);
    if (n > 0.3) discard;
    o_color = vec4(v_normal, 1.0);
}
