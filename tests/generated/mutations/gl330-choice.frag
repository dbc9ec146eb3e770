#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x)) + tan(sin(p.y));
}
void main() {
    float a = v_position.x > 0.1 ? wave(v_position) : 0.5 * wave(v_normal);
    o_color = vec4(a, a * a, v_normal.x, 1.0);
}
