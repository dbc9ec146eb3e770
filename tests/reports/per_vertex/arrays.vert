#version 450 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
layout(location = 0) out vec3 v_p; layout(location = 1) out vec3 v_n; layout(location = 2) out vec3 v_t;
void main() { v_p = a_position; v_n = a_normal; v_t = a_normal; gl_Position = u_mvp * vec4(a_position, 1.0); }
