#version 330
// The same with the test behind the body, and the loop inside a branch.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

float march(vec3 p) {
    float reach = wave(p) * 0.5;
    if (p.x > -0.2) {
        int i = 0;
        do {
            reach += 0.1 * wave(p + reach);
            if (reach > 0.4)
                return reach;
        } while (++i < 4);
    }
    return reach + wave(p * 3.0);
}

void main() {
    float a = march(v_position);
    o_color = vec4(a, a * march(v_normal * 0.5), wave(v_position.zyx), 1.0) * 0.5;
}
