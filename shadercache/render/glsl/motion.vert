#version 330
// Where the vertices of a frame are, and where the same were in the frame before: both captured.
in vec4 a_now;
in vec4 a_before;
uniform float u_number;
uniform int u_corners;
out vec4 v_before;
flat out float v_number;  // of the instance

void main() {
    v_before = a_before;
    v_number = u_number + float(gl_VertexID / u_corners);
    gl_Position = a_now;
}
