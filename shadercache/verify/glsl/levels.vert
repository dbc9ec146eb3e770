#version 400
out vec2 v_at;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
    v_at = corner * 3.0 + 0.3 * corner.yx;
    gl_Position = vec4(corner, 0.0, 1.0);
}
