// REFUSED: SC461 gl_ViewportMask
#version 450 core
#extension GL_NV_viewport_array2 : require
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
void main() { v_p = a_position; v_n = a_normal; gl_ViewportMask[0] = 3; gl_Position = u_vp * vec4(a_position, 1.0); }
