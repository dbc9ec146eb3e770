#version 330
// Board and pieces stand still; the king is moved by the model matrix.

in vec3 a_position;
in vec3 a_normal;
in vec2 a_uv;

uniform mat4 u_model;           // a shift, so it may turn normals too
uniform mat4 u_viewProjection;

out vec3 v_world;   // world space
out vec3 v_normal;  // world space
out vec2 v_uv;

void main() {
    vec4 world = u_model * vec4(a_position, 1.0);
    v_world = world.xyz;
    v_normal = mat3(u_model) * a_normal;
    v_uv = a_uv;
    gl_Position = u_viewProjection * world;
}
