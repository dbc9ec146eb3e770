#version 330
// Two values of an integer hash and of floats in one struct.
in vec3 v_position;
out vec4 o_color;
struct Cell {
    vec2 at;
    bool odd;
};
Cell cell(vec3 p) {
    return Cell(fract(p.xy * 3.0) * exp(-p.z), (int(floor(p.x * 2.0)) & 1) == 1);
}
void main() {
    Cell found = cell(v_position); // the node
    o_color = vec4(found.at, found.odd ? 1.0 : 0.2, 1.0);
}
