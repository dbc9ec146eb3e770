// On a surface: spots of NaN, of both infinities and of huge numbers, which clamp() swallows.
#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    vec3 wave = sin(9.0 * v_position) * cos(5.0 * v_position.yzx);
    vec3 odd = vec3(sqrt(wave.x + 0.6), wave.y / floor(2.0 + 2.0 * wave.z), log(wave.z));
    o_color = vec4(clamp(odd, vec3(-0.9), vec3(0.9)) * (0.6 + 0.4 * normalize(v_normal).z), 1.0);
}
