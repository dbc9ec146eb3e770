#version 430
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
out vec3 v_p;
out vec3 v_n;
struct Eye {
    mat4 view;
    mat4 projection;
};
layout(location = 4) uniform Eye u_eyes[2];
layout(std140, binding = 0) uniform Thing {
    mat4 model;
};
void main() {
    v_p = a_position;
    v_n = a_normal;
    gl_Position = u_eyes[1].projection * u_eyes[1].view * model * vec4(a_position, 1.0);
}
