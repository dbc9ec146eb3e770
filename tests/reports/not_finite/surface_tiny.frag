// On a surface: what fades away below the smallest normal number, and what is made of it again.
#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
void main() {
    float wave = sin(9.0 * v_position.x) * cos(5.0 * v_position.y);
    float tiny = exp2(-125.0 + 6.0 * wave) * (1.5 + wave);
    o_color = vec4(vec3(tiny * 1e37 * 1e1) * (0.6 + 0.4 * normalize(v_normal).z), 1.0);
}
