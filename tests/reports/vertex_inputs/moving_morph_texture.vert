// TWINNED: morphTargetsTexture
#version 330 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
uniform sampler2DArray morphTargetsTexture; uniform float u_weights[2];
void main() {
    v_p = a_position; v_n = a_normal;
    vec3 p = a_position; for (int k = 0; k < 2; k++) p += u_weights[k] * texelFetch(morphTargetsTexture, ivec3(gl_VertexID, 0, k), 0).xyz; gl_Position = u_vp * vec4(p, 1.0);
}
