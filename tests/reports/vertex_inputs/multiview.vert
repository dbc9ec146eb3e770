// REFUSED: SC461 num_views
#version 330 core
#extension GL_OVR_multiview : require
layout(num_views = 2) in;
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
uniform mat4 u_views[2];
void main() { v_p = a_position; v_n = a_normal; gl_Position = u_views[gl_ViewID_OVR] * vec4(a_position, 1.0); }
