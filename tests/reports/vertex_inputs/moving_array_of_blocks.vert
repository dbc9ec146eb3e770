// TWINNED: Bones
#version 430 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
layout(std140, binding = 1) uniform Place { mat4 m; } place[2]; layout(std430, binding = 0) readonly buffer Bones { mat4 m[]; } bones;
void main() {
    v_p = a_position; v_n = a_normal;
    gl_Position = u_vp * place[1].m * bones.m[2] * vec4(a_position, 1.0);
}
