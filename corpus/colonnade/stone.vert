#version 330
// Stone does not move; the camera does.

in vec3 a_position;
in vec3 a_normal;

uniform mat4 u_model;           // a shift, so it may turn normals too
uniform mat4 u_viewProjection;

out vec3 v_world;   // world space
out vec3 v_normal;  // world space

void main() {
    vec4 world = u_model * vec4(a_position, 1.0);
    v_world = world.xyz;
    v_normal = mat3(u_model) * a_normal;
    gl_Position = u_viewProjection * world;
}
