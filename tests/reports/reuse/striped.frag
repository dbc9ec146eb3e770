#version 330
// A value that not every pixel has.
in vec3 v_position;
out vec4 o_color;
float noise(vec3 p) {
    return fract(sin(dot(p, vec3(1.7, 2.9, 3.3))) * 7.0) + pow(abs(p.z), 1.3);
}
void main() {
    vec3 color = vec3(0.2, 0.4, 0.6);
    if (sin(8.0 * v_position.y) > 0.0) {
        color += noise(v_position); // the node
    }
    o_color = vec4(color, 1.0);
}
