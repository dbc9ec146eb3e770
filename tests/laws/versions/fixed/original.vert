#version 330 core
// shadercache: original, unchanged

uniform mat3 legacy_NormalMatrix;
in vec3 legacy_Normal;
uniform mat4 legacy_ModelViewMatrix;
in vec4 legacy_Vertex;
out vec4 legacy_TexCoord[1];
in vec4 legacy_MultiTexCoord0;
out vec4 legacy_FrontColor;
out float legacy_FogFragCoord;
uniform mat4 legacy_ModelViewProjectionMatrix;
out vec3 normal;
out vec3 eye;

void main() {
    normal = legacy_NormalMatrix * legacy_Normal;
    eye = vec3(legacy_ModelViewMatrix * legacy_Vertex);
    legacy_TexCoord[0] = legacy_MultiTexCoord0;
    legacy_FrontColor = vec4(1.0);
    legacy_FogFragCoord = length(eye);
    gl_Position = legacy_ModelViewProjectionMatrix * legacy_Vertex;
}
