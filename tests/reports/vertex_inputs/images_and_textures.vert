// NAMED: u_heights, u_offsets, u_rows
#version 430 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
uniform sampler2D u_heights; uniform samplerBuffer u_offsets;
layout(binding = 0, rgba32f) readonly uniform image2D u_rows;
void main() {
    v_p = a_position; v_n = a_normal;
    vec4 p = texture(u_heights, a_position.xy) + texelFetch(u_offsets, 2) + imageLoad(u_rows, ivec2(0));
    gl_Position = u_vp * p;
}
