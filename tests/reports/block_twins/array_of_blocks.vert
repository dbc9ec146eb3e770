#version 430
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
out vec3 v_p;
out vec3 v_n;
layout(std140, binding = 0) uniform Part {
    vec2 unread;
    mat4 part;
} parts[3];
void main() {
    v_p = a_position;
    v_n = a_normal;
    gl_Position = parts[0].part * parts[1].part * parts[2].part * vec4(a_position, 1.0);
}
