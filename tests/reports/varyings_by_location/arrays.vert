#version 410 core
// Arrays and matrices take several locations.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
uniform mat4 u_mvp;
layout(location = 0) out vec3 parts[2]; layout(location = 2) out mat3 frame; layout(location = 5) out vec3 last;
void main() { parts[0] = a_position; parts[1] = a_normal; frame = mat3(1.0); last = a_normal; gl_Position = u_mvp * vec4(a_position, 1.0); }
