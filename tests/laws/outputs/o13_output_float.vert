#version 330
in vec3 position;
in vec3 normal;
uniform mat4 mvp;
out vec3 v_p;
out vec3 v_n;

void main() {
    v_p = position;
    v_n = normal;
    gl_Position = mvp * vec4(position, 1.0);
}
