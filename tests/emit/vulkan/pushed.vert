#version 450
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 0) out Surface {
    vec3 v_position;
    vec3 v_normal;
};
layout(set = 0, binding = 7) uniform Camera {
    mat4 view_projection;
} u_cameras[2];
layout(push_constant, std430) uniform Draw {
    mat4 u_model;
    vec3 u_tint[2];
};

void main() {
    v_position = (u_model * vec4(a_position, 1.0)).xyz;
    v_normal = mat3(u_model) * a_normal;
    gl_Position = u_cameras[1].view_projection * vec4(v_position, 1.0);
}
