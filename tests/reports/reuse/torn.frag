#version 330
// What is behind shows through the holes.
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    if (fract(4.0 * v_position.x) < 0.3) {
        discard;
    }
    vec3 glow = exp(-v_position * v_position) * cos(7.0 * v_normal); // the node
    o_color = vec4(abs(glow), 1.0);
}
