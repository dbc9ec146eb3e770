#version 330
in vec3 position;
in vec3 normal;
uniform mat4 mvp;
uniform mat4 bones[2];
out vec3 p;
out vec3 n;

void main() {
    float upper = smoothstep(-0.6, 0.6, position.y);
    p = position;
    n = normal;
    gl_Position = mvp * (bones[0] * (1.0 - upper) + bones[1] * upper) * vec4(position, 1.0);
}
