#version 330 core
// The position is only marked again; there is no block.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n;
uniform mat4 u_mvp;
invariant gl_Position;
void main() { v_p = a_position; v_n = a_normal; (gl_Position) = u_mvp * vec4(a_position, 1.0); }
