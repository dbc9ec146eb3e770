#version 330 core
uniform vec2 u_resolution;
#define SIZE 400000
layout(std140) uniform Many {

    vec4 all[SIZE];
} many;
out vec4 o;
void main() {
    o = many.all[int(u_resolution.x)] * exp(sin(u_resolution.y * 9.0)); }
