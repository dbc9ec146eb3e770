#version 330
// Fetches with implicit level of detail in every form that one pass may split, and some it may not.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform sampler2D u_map;
uniform samplerCube u_sky;
out vec4 o_color;

vec3 layer(vec2 at, float more) {
    vec4 base = texture(u_map, at * 1.7);
    return base.rgb * texture(u_map, at + base.xy * 0.1, more).a;
}

void main() {
    vec3 sum = layer(v_uv * 2.0, 0.5) + layer(v_uv.yx * 3.0, -0.5).zxy;
    sum += texture(u_sky, v_normal).rgb + textureOffset(u_map, v_uv * 5.0, ivec2(1, 0)).rgb;
    vec3 detail = textureProj(u_map, vec3(v_uv * 4.0, 1.5)).rgb * sin(v_position.x * 9.0);
    o_color = vec4(sqrt(sum * 0.3) + detail * 0.1, 1.0);
}
