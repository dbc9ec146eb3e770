#version 330
// A loop that may return comes last behind one value, and first before the other.
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
    while (reach < 0.6) {
        reach += 0.3 + 0.1 * wave(p + reach);
        if (reach > 0.4)
            return reach;
    }
    return reach + wave(p * 3.0);
}

void main() {
    o_color = vec4(march(v_position), march(v_normal * 0.5), wave(v_normal), 1.0) * 0.5;
}
