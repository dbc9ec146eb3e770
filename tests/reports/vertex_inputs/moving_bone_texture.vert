// TWINNED: u_boneMatrices
// NAMED: a_position, a_bone
#version 330 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
in float a_bone; uniform sampler2D u_boneMatrices;
mat4 posed(float i) { int at = 4 * int(i); mat4 m; for (int k = 0; k < 4; k++) m[k] = texelFetch(u_boneMatrices, ivec2(at + k, 0), 0); return m; }
void main() {
    v_p = a_position; v_n = a_normal;
    gl_Position = u_vp * posed(a_bone) * vec4(a_position, 1.0);
}
