#version 410 core
// What is declared and not read needs no counterpart.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
layout(location = 0) out vec3 v_p; layout(location = 1) out vec3 v_n; layout(location = 7) out float unread;
void main() { v_p = a_position; v_n = a_normal; unread = 1.0; gl_Position = u_mvp * vec4(a_position, 1.0); }
