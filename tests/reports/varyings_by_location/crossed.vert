#version 410 core
// Each name is the other's in the other stage.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
layout(location = 0) out vec3 v_n; layout(location = 1) out vec3 v_p;
void main() { v_n = a_position; v_p = a_normal; gl_Position = u_mvp * vec4(a_position, 1.0); }
