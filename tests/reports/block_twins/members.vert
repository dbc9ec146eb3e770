#version 430
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
out vec3 v_p;
out vec3 v_n;
layout(std140, binding = 1) uniform Camera {
    float unread;
    mat4 view;
    mat4 projection;
};
layout(location = 3) uniform mat4 u_model;
void main() {
    v_p = a_position;
    v_n = a_normal;
    gl_Position = projection * view * u_model * vec4(a_position, 1.0);
}
