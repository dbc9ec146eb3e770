#version 410 core
// One stage alone has places: names match.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
out vec3 v_n; out vec3 v_p;
void main() { v_p = a_position; v_n = a_normal; gl_Position = u_mvp * vec4(a_position, 1.0); }
