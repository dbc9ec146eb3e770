#version 330
// Loops whose body runs before the test, with break and continue.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void main() {
    float t = wave(v_position) * 0.5;
    int turns = 0;
    do {
        turns++;
        if (turns == 2)
            continue;
        t += 0.25 * wave(v_normal + t);
        if (t > 1.5)
            break;
    } while (t < 1.0 && turns < 6);
    float after = wave(v_position * t);
    float apart = wave(v_normal * 2.0);
    while (turns > 3)
        turns--;
    o_color = vec4(t, after, apart * after, float(turns) * 0.25);
}
