#version 330
// Loops that are not unrolled, each for a reason of its own; those around them may be.
in vec3 v_position;
in vec3 v_normal;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

void advance(inout int i) {
    i += 1;
}

void main() {
    float a = 0.0;
    int count = int(u_time * 10.0);
    for (int i = 0; i < 3; i++) {
        if (a > 0.5) break;
        a += wave(v_position * float(i));
    }
    for (int i = 0; i < 3; i++) {
        if (a > float(i)) continue;
        a += wave(v_position + float(i));
    }
    for (int i = 0; i < 3; i++) {
        a += wave(v_position - float(i));
        i++;
    }
    for (int i = 0; i < 3;) {
        a += wave(v_position * 0.5 - float(i));
        advance(i);
    }
    int i;
    for (i = 0; i < 3; i++) a += wave(v_normal * float(i));
    for (int i = 0; i < count; i++) a += wave(v_normal + float(i));
    for (int i = 0; i < 65; i++) a += 0.001 * wave(v_normal - float(i));
    for (int i = 0; i < 3; i += count) a += wave(v_normal * 0.5 - float(i));
    for (int i = int(a); i < 3; i++) a += 0.125;
    for (int i = 3; i < 3; i++) a += wave(v_normal);
    for (;;) {
        a += 0.5;
        if (a > 1.0) break;
    }
    // Ten by ten are too many, but ten are not.
    for (int i = 0; i < 10; i++) {
        for (int j = 0; j < 10; j++) a += 0.01 * wave(v_position * float(i - j));
    }
    // The inner one stays.
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 4; j++) {
            if (a > 1.5 * float(j)) break;
            a += 0.1 * wave(v_position * float(i + j));
        }
        for (int j = 0; j < count; j++) a += 0.5;
    }
    for (int i = 0; i < 2; i++) {
        struct Local { float x; } local;
        local.x = wave(v_normal * 2.0);
        a += local.x;
    }
    o_color = vec4(fract(a), a * 0.1, 0.5, 1.0);
}
