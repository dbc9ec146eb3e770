#version 420 core
uniform float u_time;
in vec3 v_normal;
out vec4 colour;

void main() {
    vec3 light = { exp(sin(v_normal.x * 9.0 + u_time)), exp(cos(v_normal.y * 7.0)), 0.5 };
    mat3 turn = { light, light.yzx, { exp(sin(light.z)), 1.0, 0.0 } };
    colour = vec4(turn * normalize(v_normal), 1.0);
}
