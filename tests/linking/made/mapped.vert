#version 330 core
in vec3 a_position;
in vec3 a_normal;
in vec4 a_tangent;
in vec2 a_uv;

uniform mat4 u_mvp;
uniform mat4 u_model;
uniform mat3 u_normalMatrix;

out vec3 v_world;
out vec2 v_uv;
out mat3 v_frame;

void main() {
    vec3 normal = normalize(u_normalMatrix * a_normal);
    vec3 tangent = normalize(u_normalMatrix * a_tangent.xyz);
    v_frame = mat3(tangent, cross(normal, tangent) * a_tangent.w, normal);
    v_uv = a_uv;
    v_world = (u_model * vec4(a_position, 1.0)).xyz;
    gl_Position = u_mvp * vec4(a_position, 1.0);
}
