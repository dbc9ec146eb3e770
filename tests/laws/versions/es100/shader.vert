#version 100
attribute vec3 position;
attribute vec3 normal;
attribute vec2 texcoord;
uniform mat4 mvp;
varying highp vec2 uv;
varying vec3 n;

void main() {
    uv = texcoord;
    n = normal;
    gl_Position = mvp * vec4(position, 1.0);
}
