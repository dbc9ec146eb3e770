#version 330
// A dome around everything; it is not worth a cache.

in vec3 a_position;

uniform mat4 u_viewProjection;

out vec3 v_world;  // world space

void main() {
    v_world = a_position;
    gl_Position = u_viewProjection * vec4(a_position, 1.0);
}
