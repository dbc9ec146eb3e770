#version 400
#extension GL_ARB_derivative_control : enable
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
in vec4 v_clip;
noperspective in vec2 v_linear;
in Seen { vec2 place; float far; } seen;
uniform sampler2D u_map;
uniform float u_gain;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

