#version 330 core
// shadercache: original, unchanged

in vec3 position;
in vec3 normal;
in vec2 texcoord;
uniform mat4 mvp;
out vec2 uv;
out vec3 n;

void main() {
    uv = texcoord;
    n = normal;
    gl_Position = mvp * vec4(position, 1.0);
}
