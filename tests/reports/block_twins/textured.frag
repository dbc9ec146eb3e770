#version 430
in vec3 v_p;
in vec3 v_n;
layout(location = 0) out vec4 o;
layout(binding = 0) uniform sampler2D u_map;
layout(location = 5) uniform float u_gain;
vec3 costly(vec3 p) {
    vec3 s = sin(p * 5.0);
    for (int i = 0; i < 3; i++)
        s = exp(sin(s.yzx * 2.0 + p));
    return s * 0.3 + textureLod(u_map, p.xy, 0.0).rgb * u_gain;
}
void main() { o = vec4(costly(v_p) * max(v_n.z, 0.2), 1.0); }
