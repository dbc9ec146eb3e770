// Places on the screen: of the fragment, of varyings, by level of detail, and of which face is seen.
void main() {
    float dither = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453);
    float deep = wave(vec3(gl_FragCoord.z * 9.0, gl_FragCoord.w * 3.0, 1.0));
    vec3 facing = gl_FrontFacing ? v_normal : -v_normal;
    float lit = wave(facing);
    float number = wave(vec3(gl_PrimitiveID));
    vec2 screen = v_clip.xy / v_clip.w;
    float clip = wave(vec3(screen * 9.0, 1.0));
    float block = wave(vec3(seen.place * 7.0, 0.5));
    float away = wave(vec3(seen.far));
    float linear = wave(vec3(v_linear, 2.0));
    float level = wave(vec3(textureQueryLod(u_map, v_uv * 3.0), 1.0));
    float both = wave(vec3(fwidth(gl_FragCoord.z) * 99.0, dFdx(screen)));
    o_color = vec4(dither * 0.1 + deep, lit, number, clip);
    o_color += vec4(block, away, linear, level) + vec4(both);
}
