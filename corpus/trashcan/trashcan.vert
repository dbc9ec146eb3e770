#version 330
// The can turns in front of a fixed camera, and the yard it reflects stands still.

in vec3 a_position;  // object space
in vec3 a_normal;    // object space, unit length, outward
in vec3 a_tangent;   // object space, unit length, along u
in vec2 a_uv;        // repetitions of the normal map

uniform mat4 u_modelViewProjection;
uniform mat4 u_model;  // a rotation, so it may turn normals too

out vec3 v_world;      // world space, like the three axes below
out vec3 v_tangent;
out vec3 v_bitangent;
out vec3 v_normal;
out vec2 v_uv;

void main() {
    v_world = (u_model * vec4(a_position, 1.0)).xyz;
    v_tangent = mat3(u_model) * a_tangent;
    v_normal = mat3(u_model) * a_normal;
    v_bitangent = cross(v_normal, v_tangent);
    v_uv = a_uv;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}
