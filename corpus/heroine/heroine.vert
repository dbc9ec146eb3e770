#version 330
// The heroine walks: 23 bones move her skin, four of them each vertex.

in vec3 a_position;  // at rest
in vec3 a_normal;    // at rest, unit length, outward
in vec3 a_seams;     // how far inside of cloth, leather and hair: 1/2 at the seam
in vec4 a_bones;     // numbers of the bones that move this vertex
in vec4 a_weights;   // by how much each does, together 1

uniform mat4 u_model;           // where she stands; a rotation, so it may turn normals too
uniform mat4 u_viewProjection;
uniform mat4 u_bones[23];

out vec3 v_rest;    // at rest: what she is made of does not move with her
out vec3 v_seams;
out vec3 v_normal;  // world space
out vec3 v_world;   // world space

void main() {
    mat4 bone = u_bones[int(a_bones.x)] * a_weights.x + u_bones[int(a_bones.y)] * a_weights.y
        + u_bones[int(a_bones.z)] * a_weights.z + u_bones[int(a_bones.w)] * a_weights.w;
    vec4 world = u_model * (bone * vec4(a_position, 1.0));
    v_rest = a_position;
    v_seams = a_seams;
    v_normal = mat3(u_model) * (mat3(bone) * a_normal);
    v_world = world.xyz;
    gl_Position = u_viewProjection * world;
}
