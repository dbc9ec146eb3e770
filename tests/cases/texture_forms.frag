#version 330
// textureLod, textureProj, textureOffset, texelFetch, textureSize and a bias.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
uniform sampler2D u_map;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void main() {
    vec4 a = textureLod(u_map, v_uv, 1.5);
    vec4 b = textureProj(u_map, vec3(v_uv, 1.25)) + textureProj(u_map, vec4(v_uv, 0.0, 2.0));
    vec4 c = textureOffset(u_map, v_uv, ivec2(1, -2));
    vec4 d = texelFetch(u_map, ivec2(v_uv * 15.0) % textureSize(u_map, 0), 0);
    vec4 e = texture(u_map, v_uv * 3.0, 1.0) * wave(v_position);
    vec4 f = textureProjLod(u_map, vec3(v_uv, 1.5), 0.5) + textureLodOffset(u_map, v_uv, 0.0, ivec2(1));
    vec3 g = texture(u_map, a.xy).rgb * wave(v_normal);
    o_color = vec4(g, 1.0) + (a + b + c) * 0.25 + d * e.x + f * 0.125;
}
