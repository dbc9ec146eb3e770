#version 120
attribute vec3 position;
attribute vec3 normal;
uniform mat4 mvp;
varying vec3 p;
varying vec3 n;

void main() {
    p = position;
    n = normal;
    gl_Position = mvp * vec4(position, 1.0);
}
