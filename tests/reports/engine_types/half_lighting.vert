#version 450
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_uv;
layout(location = 0) out vec3 v_position;
layout(location = 1) out vec3 v_normal;
layout(location = 2) out vec2 v_uv;
uniform mat4 u_model;
uniform mat4 u_view_projection;
void main() {
    v_position = (u_model * vec4(a_position, 1.0)).xyz;
    v_normal = mat3(u_model) * a_normal;
    v_uv = a_uv;
    gl_Position = u_view_projection * vec4(v_position, 1.0);
}
