#version 440 core
// Structs without names match by their members, at a place or by the variable's name.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
layout(location = 2) out struct { vec3 at; vec3 facing; } surface; out struct { float one; } plain;
void main() { surface.at = a_position; surface.facing = a_normal; plain.one = 1.0; gl_Position = u_mvp * vec4(a_position, 1.0); }
