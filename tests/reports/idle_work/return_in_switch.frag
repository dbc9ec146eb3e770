#version 330
// The same with a switch of which every case returns.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

float pick(vec3 p, int which) {
    float reach = wave(p) * 0.5;
    switch (which) {
    case 0:
        return reach * wave(p * 2.0);
    case 1:
        for (int i = 0; i < 3; i++) {
            reach += wave(p + reach);
            if (reach > 1.0)
                return reach;
        }
        return reach * 0.3;
    }
    return reach + wave(p * 3.0);
}

void main() {
    int which = int(v_uv.x * 3.0);
    o_color = vec4(pick(v_position, which), pick(v_normal, 2 - which), 0.4, 1.0);
}
