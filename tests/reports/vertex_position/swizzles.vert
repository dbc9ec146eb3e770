#version 410 core
// Written by swizzles, by an index and by compound assignments.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n;
uniform mat4 u_mvp;
out gl_PerVertex { invariant vec4 gl_Position; };
void main() {
    v_p = a_position; v_n = a_normal;
    vec4 clip = u_mvp * vec4(a_position, 1.0);
    gl_Position.yx = clip.yx;
    gl_Position[2] = clip.z;
    int last = 3;
    gl_Position[last] = clip.w - 1.0;
    gl_Position.w += 1.0;
}
