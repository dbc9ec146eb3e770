#version 330
// A value of every pixel.
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    vec3 bands = sin(9.0 * v_position) * cos(5.0 * v_position.yzx); // the node
    o_color = vec4(0.5 + 0.5 * bands * normalize(v_normal).z, 1.0);
}
