// REFUSED: SC461 gl_Layer
#version 450 core
#extension GL_ARB_shader_viewport_layer_array : require
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
void to(int layer) { gl_Layer = layer; }
void main() { v_p = a_position; v_n = a_normal; to(1); gl_Position = u_vp * vec4(a_position, 1.0); }
