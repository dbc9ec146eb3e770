// MOVING: u_rows
// TWINNED: u_rows
#version 430 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
layout(binding = 1, rgba32f) readonly uniform image2D u_rows;
void main() {
    v_p = a_position; v_n = a_normal;
    gl_Position = u_vp * imageLoad(u_rows, ivec2(0)) + vec4(a_position, 1.0);
}
