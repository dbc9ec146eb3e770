#version 440 core
// Components of one location.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
layout(location = 0, component = 0) out vec2 xy; layout(location = 0, component = 2) out float z; layout(location = 1) out vec3 facing;
void main() { xy = a_position.xy; z = a_position.z; facing = a_normal; gl_Position = u_mvp * vec4(a_position, 1.0); }
