// REFUSED: SC461 gl_ViewIndex
#version 450 core
#extension GL_EXT_multiview : require
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
uniform mat4 u_views[2];
mat4 view() { return u_views[gl_ViewIndex]; }
void main() { v_p = a_position; v_n = a_normal; gl_Position = view() * vec4(a_position, 1.0); }
