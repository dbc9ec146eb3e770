#version 330
// Stripes that move with the surface.
in vec3 v_position;
in vec3 v_normal;
layout(location = 0) out vec4 o_color;

void main() {
    vec3 wave = sin(9.0 * v_position + vec3(0.0, 2.0, 4.0));
    o_color = vec4(0.55 + 0.3 * wave * normalize(v_normal).zxy, 1.0);
}
