#version 330
// Where the vertices of a frame are, and where the same were in the frame before: both captured.
in vec4 a_now;
in vec4 a_before;
out vec4 v_before;

void main() {
    v_before = a_before;
    gl_Position = a_now;
}
