#version 330
// A second output: no value of the shader can be cached yet.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
layout(location = 0) out vec4 o_color;

layout(location = 1) out vec4 o_normal;

void main() {
    o_color = vec4(sin(v_position * 3.0) * u_time, 1.0);
    o_normal = vec4(normalize(v_normal), 0.0);
}
