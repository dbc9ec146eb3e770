#version 330
// Two costly patterns on the surface, one that moves, and light.

uniform sampler2D u_grain;
uniform vec3 u_eye;
uniform float u_time;

in vec3 v_position;
in vec3 v_normal;

out vec4 o_color;

float wave(vec3 p, float turn)
{
    vec3 q = sin(p * 3.1 + turn) * cos(p.yzx * 1.7) + sin(p.zxy * 5.3) * cos(p * 2.9);
    q += pow(abs(sin(q * 7.1)), vec3(2.2)) * exp(-dot(q, q)) + pow(abs(cos(q * 3.3)), vec3(1.4));
    q += pow(abs(sin(q * 9.7)), vec3(3.2)) * exp(-dot(p, q)) + pow(abs(cos(q * 1.9)), vec3(1.8));
    q += pow(abs(sin(q * 2.3)), vec3(1.2)) * exp(-dot(q, p)) + pow(abs(cos(q * 8.5)), vec3(1.1));
    return length(q) + texture(u_grain, q.xy).r + texture(u_grain, q.yz).r;
}

void main()
{
    float veins = wave(v_position, 0.0) + wave(v_position * 2.0, 0.5);
    float drift = wave(v_position, u_time);
    vec3 view = normalize(u_eye - v_position);
    float lit = max(dot(normalize(v_normal), view), 0.0);
    o_color = vec4(vec3(veins, drift, veins * drift) * lit, 1.0);
}
