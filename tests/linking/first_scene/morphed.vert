#version 330
in vec3 POSITION;
in vec3 NORMAL;
in vec3 morphTarget0;
in vec3 morphTarget1;

uniform float morphTargetInfluences[2];
uniform mat4 u_ModelMatrix;
uniform mat4 u_ViewMatrix;
uniform mat4 u_ProjMatrix;

out vec3 vPos;
out vec3 vNormal;
out vec3 vWorld;

void main() {
    vec3 moved = POSITION + morphTargetInfluences[0] * morphTarget0
        + morphTargetInfluences[1] * morphTarget1;
    vec4 place = u_ModelMatrix * vec4(moved, 1.0);
    vPos = POSITION;
    vNormal = mat3(u_ModelMatrix) * NORMAL;
    vWorld = place.xyz;
    gl_Position = u_ProjMatrix * u_ViewMatrix * place;
}
