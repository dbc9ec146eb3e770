#version 400 core
// Interpolation on the screen, and at another place of the pixel.
in vec3 a_position; in vec2 a_uv;
uniform mat4 u_mvp;
noperspective out vec3 v_edge; out vec2 v_uv; centroid out vec2 v_middle; flat out vec3 v_flat;
noperspective out vec4 v_carried;
out Lines { noperspective vec3 far; vec3 near; } lines;
void main() {
    v_edge = a_position; v_uv = a_uv; v_middle = a_uv; v_flat = a_position;
    lines.far = a_position; lines.near = a_position;
    v_carried = u_mvp * vec4(a_position, 1.0);
    gl_Position = u_mvp * vec4(a_position, 1.0);
}
