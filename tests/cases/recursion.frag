#version 330
// Recursion, which GLSL forbids: told where it is.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float down(float x) { return x < 0.1 ? x : down(x * 0.5) + 1.0; }

void main() {
    o_color = vec4(down(v_uv.x));
}
