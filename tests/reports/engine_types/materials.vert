#version 450
layout(location = 0) in vec3 a_position;
layout(location = 1) in int a_material;
layout(location = 0) out vec3 v_position;
layout(location = 1) flat out int v_material;
uniform mat4 u_model;
uniform mat4 u_view_projection;
void main() {
    v_material = a_material;
    v_position = (u_model * vec4(a_position, 1.0)).xyz;
    gl_Position = u_view_projection * vec4(v_position, 1.0);
}
