#version 330 core
layout(location = 0) in vec3 aPos;
layout(location = 1) in vec3 aNormal;

uniform mat4 uMVP;
uniform mat4 uModel;

out vec3 vPos;
out vec3 vNormal;
out vec3 vWorld;

void main() {
    vPos = aPos;
    vNormal = mat3(uModel) * aNormal;
    vWorld = (uModel * vec4(aPos, 1.0)).xyz;
    gl_Position = uMVP * vec4(aPos, 1.0);
}
