#version 330 core
// shadercache: original, unchanged

in vec3 position;
in vec3 normal;
in vec2 texcoord;
uniform mat4 mvp;

out Surface {
    vec2 uv;
    vec3 n;
} surface;

void main() {
    surface.uv = texcoord;
    surface.n = normal;
    gl_Position = mvp * vec4(position, 1.0);
}
