#version 330 core
// shadercache: original, unchanged

uniform sampler2D picture;
uniform float time;

in Surface {
    vec2 uv;
    vec3 n;
} surface;

layout(location = 0) out vec4 color;

float bands(vec2 p) {
    float s = 0.0;
    for (int i = 1; i < 6; i++) {
        s += sin(p.x * float(i) * 9.0 + time) / float(i);
    }
    return s;
}

void main() {
    float b = bands(surface.uv) + bands(surface.uv.yx);
    color = vec4(abs(normalize(surface.n)) * b, 1.0);
}
