// On a surface: seven numbers, of which the last three are not finite now and then.
#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
struct Lit { vec4 base; vec3 more; };
Lit lit(vec3 at) {
    vec3 wave = sin(9.0 * at) * cos(5.0 * at.yzx);
    return Lit(wave.xyzx * 0.5 + 0.5, vec3(acos(1.6 * wave.x), 1.0 / floor(2.0 + 2.0 * wave.y), exp(1e3 * wave.z)));
}
void main() {
    Lit it = lit(v_position);
    vec3 shown = mix(vec3(0.25), it.more, lessThan(abs(it.more), vec3(2.0)));
    o_color = vec4(it.base.xyz * shown * (0.6 + 0.4 * normalize(v_normal).z), it.base.w);
}
