// TWINNED: instanceMatrix
// NOT: instanceColor
#version 330 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
in mat4 instanceMatrix; in vec3 instanceColor;
void main() {
    v_p = a_position; v_n = a_normal;
    v_n = a_normal * instanceColor; gl_Position = u_vp * instanceMatrix * vec4(a_position, 1.0);
}
