// REFUSED: SC462 atomicCounterIncrement
#version 430 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
layout(binding = 0) uniform atomic_uint u_count;
void main() { v_p = a_position; v_n = a_normal; atomicCounterIncrement(u_count); gl_Position = u_vp * vec4(a_position, 1.0); }
