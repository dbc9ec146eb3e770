// REFUSED: SC463 subgroupAdd
#version 450 core
#extension GL_KHR_shader_subgroup_arithmetic : require
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
void main() { v_p = a_position; v_n = a_normal; gl_Position = u_vp * vec4(subgroupAdd(a_position), 1.0); }
