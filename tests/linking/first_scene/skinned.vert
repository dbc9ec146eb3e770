#version 330
in vec3 inPosition;
in vec3 inNormal;
in uvec4 inJoints;
in vec4 inWeights;

uniform mat4 boneMatrices[32];
uniform mat4 world;
uniform mat4 viewProj;

out vec3 vPos;
out vec3 vNormal;
out vec3 vWorld;

void main() {
    mat4 bone = boneMatrices[inJoints.x] * inWeights.x + boneMatrices[inJoints.y] * inWeights.y
        + boneMatrices[inJoints.z] * inWeights.z + boneMatrices[inJoints.w] * inWeights.w;
    vec4 place = world * (bone * vec4(inPosition, 1.0));
    vPos = inPosition;
    vNormal = mat3(world) * (mat3(bone) * inNormal);
    vWorld = place.xyz;
    gl_Position = viewProj * place;
}
