#version 330
// A function that returns from inside a loop, and values before, in and after it.
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
    for (int i = 0; i < 5; i++) {
        reach += 0.1 * wave(p + reach);
        if (reach > 0.4)
            return reach * wave(p * 2.0);
    }
    return reach + wave(p * 3.0);
}

void main() {
    float a = march(v_position);
    float b = a * wave(v_normal);
    o_color = vec4(a, b, march(v_normal * 0.5) + 0.5, 1.0);
}
