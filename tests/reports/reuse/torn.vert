#version 330
in vec3 a_position;
in vec3 a_normal;
uniform mat4 u_mvp;
out vec3 v_position;
out vec3 v_normal;
void main() {
    v_position = a_position;
    v_normal = a_normal;
    vec4 clip = u_mvp * vec4(a_position, 1.0);
    gl_Position.xyz = clip.xyz;
    gl_Position.w = clip.w;
}
