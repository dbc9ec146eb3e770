#version 310 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texcoord;
uniform mat4 mvp;
out mediump vec2 uv;
out mediump vec3 n;

void main() {
    uv = texcoord;
    n = normal;
    gl_Position = mvp * vec4(position, 1.0);
}
