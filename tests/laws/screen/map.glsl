// A normal map whose frame comes from derivatives of varyings.
void main() {
    vec3 bump = textureLod(u_map, v_uv, 0.0).xyz * 2.0 - 1.0;
    vec3 x = dFdx(v_position), y = dFdy(v_position);
    vec2 s = dFdx(v_uv), t = dFdy(v_uv);
    vec3 normal = normalize(v_normal);
    vec3 along = normalize(x * t.y - y * s.y);
    normal = normalize(mat3(along, cross(normal, along), normal) * bump);
    o_color = vec4(wave(normal) * wave(normal.yzx * 5.0));
}
