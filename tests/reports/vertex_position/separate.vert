#version 330 core
#extension GL_ARB_separate_shader_objects : require
// Declared again outside of a block, as the extension allows (Mesa does not).
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n;
uniform mat4 u_mvp;
out vec4 gl_Position; out float gl_PointSize;
void main() {
    v_p = a_position; v_n = a_normal;
    gl_PointSize = 2.0;
    gl_Position = u_mvp * vec4(a_position * gl_PointSize * 0.5, 1.0);
}
