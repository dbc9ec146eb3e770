#version 330
// Written behind a comma, from a global that nothing reads later.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n;
uniform mat4 u_mvp;
vec4 pose;
void main() { v_p = a_position; v_n = a_normal; pose = vec4(a_position, 1.0), gl_Position = u_mvp * pose; }
