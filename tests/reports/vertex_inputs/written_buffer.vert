// REFUSED: SC462 Log
#version 430 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
layout(std430, binding = 0) buffer Log { vec4 seen[]; };
void note(vec4 p) { seen[gl_VertexID] = p; }
void main() { v_p = a_position; v_n = a_normal; gl_Position = u_vp * vec4(a_position, 1.0); note(gl_Position); }
