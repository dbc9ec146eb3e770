#version 330
// Early returns in nested calls: what follows is not always reached.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float inner(vec3 p, float limit) {
    if (p.x > limit)
        return wave(p);
    float rest = wave(p * 2.0);
    if (rest < 0.0)
        return rest * 0.5;
    return rest + wave(p.zyx);
}

float outer(vec3 p) {
    float first = inner(p, 0.1);
    if (first > 0.9)
        return 0.9;
    return first + inner(p.yzx, first);
}

void main() {
    float a = outer(v_position);
    float b = inner(v_normal, a);
    if (b > 0.8) {
        o_color = vec4(a, b, 0.5, 1.0);
        return;
    }
    o_color = vec4(a, wave(v_position * b), wave(v_normal), 1.0);
}
