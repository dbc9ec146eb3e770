#version 330 core

uniform sampler2D u_wood;
uniform vec3 u_light;

in vec3 v_position;
in vec3 v_normal;

out vec4 o_color;

float rings(vec3 at)
{
    float radius = length(at.xz) * 20.0 + texture(u_wood, at.xy).r;
    return 0.5 + 0.5 * sin(radius + sin(at.y * 3.0) * cos(at.x * 5.0));
}

void main()
{
    float lit = max(dot(normalize(v_normal), u_light), 0.0);
    o_color = vec4(vec3(rings(v_position) * lit), 1.0);
}
