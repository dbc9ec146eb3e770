// Appended to the user's vertex shader: the clip-space positions that the look-up compares.
out vec4 sc_current;
out vec4 sc_previous;
uniform int sc_first_object;  // number of the first instance that is drawn
flat out int sc_object;

void main() {
    sc_vertex();
    sc_current = gl_Position;
    sc_vertex_previous();
    sc_object = sc_first_object + gl_InstanceID;
}
