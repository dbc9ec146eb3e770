// Appended to the user's vertex shader: the clip-space positions that the look-up compares.
out vec4 sc_current;
out vec4 sc_previous;

void main() {
    sc_vertex();
    sc_current = gl_Position;
    sc_vertex_previous();
}
