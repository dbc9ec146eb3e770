#version 330
// Two loops that may return, one inside the other and one behind.
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
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 2; k++) {
            reach += 0.1 * wave(p + reach);
            if (reach > 0.5)
                return reach;
        }
    }
    float further = wave(p.yzx);
    for (int i = 0; i < 3; i++) {
        further += 0.1 * wave(p - further);
        if (further > 0.5)
            return reach * further;
    }
    return reach - further;
}

void main() { o_color = vec4(march(v_position), march(v_normal), march(u_light + v_normal), 1.0); }
