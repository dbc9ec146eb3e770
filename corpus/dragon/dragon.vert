#version 330
// The dragon turns in front of a fixed camera; its marble turns with it.

in vec3 a_position;  // object space
in vec3 a_normal;    // object space, unit length, outward

uniform mat4 u_modelViewProjection;
uniform mat4 u_model;  // a rotation, so it may turn normals too

out vec3 v_position;  // object space: the block of marble the dragon is cut from
out vec3 v_normal;    // world space
out vec3 v_world;     // world space

void main() {
    v_position = a_position;
    v_normal = mat3(u_model) * a_normal;
    v_world = (u_model * vec4(a_position, 1.0)).xyz;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}
