#version 330 core

uniform vec3 u_light;
uniform float u_scale;

in vec3 v_position;
in vec3 v_normal;

out vec4 o_color;

vec3 rings(vec3 at)
{
    vec3 turn = sin(at * u_scale + sin(at.yzx * 3.0) * cos(at.zxy * 5.0));
    return 0.5 + 0.5 * cos(6.0 * turn + exp(turn.yzx));
}

void main()
{
    float lit = max(dot(normalize(v_normal), normalize(u_light)), 0.1);
    vec3 color = rings(v_position);
    o_color = vec4(sqrt(color * lit), 1.0);
}
