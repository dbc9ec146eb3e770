#version 330
in vec3 position;
in vec3 normal;
in vec2 texcoord;
uniform mat4 mvp;
out vec3 p;
out vec3 n;
out vec2 uv;

void main() {
    p = position;
    n = normal;
    uv = texcoord;
    gl_Position = mvp * vec4(position, 1.0);
}
