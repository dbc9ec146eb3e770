#version 450
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_uv;
layout(location = 3) in mat4 a_instance;
layout(location = 0) out vec3 v_position;
layout(location = 1) out vec3 v_normal;
layout(location = 2) out vec2 v_uv;
layout(set = 0, binding = 1, std140) uniform Camera {
    mat4 u_view_projection;
    vec4 u_eye;
};
layout(set = 0, binding = 3, std430) readonly buffer Bones {
    mat4 u_bones[];
};

void main() {
    vec4 at = u_bones[0] * a_instance * vec4(a_position, 1.0);
    v_position = at.xyz;
    v_normal = mat3(a_instance) * a_normal;
    v_uv = a_uv;
    gl_Position = u_view_projection * at;
}
