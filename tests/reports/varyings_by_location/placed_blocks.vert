#version 440 core
// A block at a place, whose members follow each other; without instance names.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
layout(location = 4) out Surface { mat3 frame; vec3 at; vec3 facing; };
void main() { frame = mat3(1.0); at = a_position; facing = a_normal; gl_Position = u_mvp * vec4(a_position, 1.0); }
