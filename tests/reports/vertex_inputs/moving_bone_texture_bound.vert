// TWINNED: bones
// NAMED: heights
#version 430 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
layout(binding = 2) uniform samplerBuffer bones; layout(binding = 5) uniform sampler2D heights;
void main() {
    v_p = a_position; v_n = a_normal;
    gl_Position = u_vp * (texelFetch(bones, 3) + texture(heights, a_position.xy) + vec4(a_position, 1.0));
}
