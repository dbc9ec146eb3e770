// SAYS: a draw keeps its first instance from frame to frame (gl_BaseInstanceARB decides the position)
#version 430 core
#extension GL_ARB_shader_draw_parameters : require
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
uniform mat4 u_places[64];
void main() { v_p = a_position; v_n = a_normal; gl_Position = u_vp * u_places[gl_BaseInstanceARB] * vec4(a_position, 1.0); }
