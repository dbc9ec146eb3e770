#version 330
in vec3 position;
in vec3 normal;
uniform mat4 mvp;
uniform float weights[2];
out vec3 p;
out vec3 n;

void main() {
    vec3 swollen = 0.15 * normal, bent = vec3(0.3 * position.y * position.y, 0.0, 0.0);
    p = position;
    n = normal;
    gl_Position = mvp * vec4(position + weights[0] * swollen + weights[1] * bent, 1.0);
}
