#version 330
in vec3 position;
in vec3 normal;
in mat4 i_turn;
uniform mat4 mvp;
out vec3 p;
out vec3 n;

void main() {
    p = position;
    n = normal;
    gl_Position = mvp * i_turn * vec4(position, 1.0);
}
