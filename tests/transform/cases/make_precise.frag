//// Locals, outputs, out parameters, results and arguments.
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;

float f(float x, out float y) {
    y = x;
    if (x > 1.0)
        return x * 2.0;
    return x;
}

void main() {
    float a;
    int i = 1;
    float b = f(u_a * 2.0 + 1.0, a);
    color = vec4(a + b + float(i));
}
//// becomes
#version 400

uniform float u_a;
invariant in vec3 v_a;
precise out vec4 color;

float f(float x, precise out float y) {
    y = x;
    if (x > 1.0) {
        precise float sc_exact_1 = x * 2.0;
        return sc_exact_1;
    }
    return x;
}

void main() {
    precise float a;
    precise int i = 1;
    precise float sc_exact_1 = u_a * 2.0 + 1.0;
    precise float b = f(sc_exact_1, a);
    color = vec4(a + b + float(i));
}

//// Inputs are left alone from 4.20 on (section 4.8.1).
#version 420

uniform float u_a;
in vec3 v_a;
out vec4 color;

void main() {
    color = vec4(v_a, 1.0);
}
//// becomes
#version 420

uniform float u_a;
in vec3 v_a;
precise out vec4 color;

void main() {
    color = vec4(v_a, 1.0);
}

//// The stored payload is no side effect.
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;

float f(float x) {
    return x;
}

float sc_f(float x) {
    sc_payload = x;
    return x;
}

void main() {
    color = vec4(f(sc_f(u_a * 2.0) * 3.0));
}
//// becomes
#version 400

uniform float u_a;
invariant in vec3 v_a;
precise out vec4 color;
precise float sc_payload;

float f(float x) {
    return x;
}

float sc_f(float x) {
    sc_payload = x;
    return x;
}

void main() {
    precise float sc_exact_1 = u_a * 2.0;
    precise float sc_exact_2 = sc_f(sc_exact_1) * 3.0;
    color = vec4(f(sc_exact_2));
}

//// Conditional arguments stay where they are.
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;

float f(float x) {
    return x;
}

void main() {
    float a = u_a > 0.0 ? f(1.0 / u_a) : 0.0;
    color = vec4(a);
}
//// becomes
#version 400

uniform float u_a;
invariant in vec3 v_a;
precise out vec4 color;

float f(float x) {
    return x;
}

void main() {
    precise float a = u_a > 0.0 ? f(1.0 / u_a) : 0.0;
    color = vec4(a);
}

//// In GLSL ES everything becomes highp.
#version 300 es

precision mediump float;
in lowp vec3 v_a;
out vec4 color;

void main() {
    mediump float a = v_a.x * 2.0;
    color = vec4(a);
}
//// becomes
#version 320 es

precision highp float;
precision highp int;
precision highp sampler2D;
precision highp samplerCube;
precision highp float;
in highp vec3 v_a;
precise out vec4 color;

void main() {
    precise highp float a = v_a.x * 2.0;
    color = vec4(a);
}

//// Branches and loops have room for what comes ahead.
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;

float f(float x) {
    return x;
}

void main() {
    float a = 0.0;
    if (u_a > 0.0)
        a = f(u_a * 2.0);
    else
        a = f(u_a * 3.0);
    for (float t = 0.0; t < 2.0; t += 1.0)
        a += f(t * 2.0);
    color = vec4(a);
}
//// becomes
#version 400

uniform float u_a;
invariant in vec3 v_a;
precise out vec4 color;

float f(float x) {
    return x;
}

void main() {
    precise float a = 0.0;
    if (u_a > 0.0) {
        precise float sc_exact_1 = u_a * 2.0;
        a = f(sc_exact_1);
    } else {
        precise float sc_exact_2 = u_a * 3.0;
        a = f(sc_exact_2);
    }
    for (precise float t = 0.0; t < 2.0; t += 1.0) {
        precise float sc_exact_3 = t * 2.0;
        a += f(sc_exact_3);
    }
    color = vec4(a);
}

//// What decides a choice, a loop or a case is precise.
#version 330
uniform float u_a;
out vec4 color;
bool high(float x) { return fract(x * 2.1 * 3.3) > 0.5; }
void main() {
    float x = u_a;
    if (x * 2.1 * 3.3 > 0.5) x += 1.0; else if (high(x)) x += 2.0;
    x += x * 2.1 > 0.7 ? 1.0 : 0.5;
    for (int i = 0; float(i) < x * 2.1; i++) x -= 0.1;
    while (x < 1.0) x += 0.1;
    do { x += 0.3; } while (x * 2.1 < u_a);
    switch (int(x * 2.1 * 3.3)) {
    case 0:
        float y = x * 2.0;
        x = y;
    }
    color = vec4(x);
}
//// becomes
#version 400

uniform float u_a;
precise out vec4 color;

bool high(float x) {
    precise bool sc_exact_1 = fract(x * 2.1 * 3.3) > 0.5;
    return sc_exact_1;
}

void main() {
    precise float x = u_a;
    precise bool sc_exact_2 = x * 2.1 * 3.3 > 0.5;
    if (sc_exact_2) {
        x += 1.0;
    } else {
        precise bool sc_exact_1 = high(x);
        if (sc_exact_1) {
            x += 2.0;
        }
    }
    precise bool sc_exact_3 = x * 2.1 > 0.7;
    x += sc_exact_3 ? 1.0 : 0.5;
    {
        precise bool sc_exact_4;
        for (precise int i = 0; sc_exact_4 = float(i) < x * 2.1; i++) {
            x -= 0.1;
        }
    }
    while (x < 1.0) {
        x += 0.1;
    }
    {
        precise bool sc_exact_5;
        do {
            x += 0.3;
        } while (sc_exact_5 = x * 2.1 < u_a);
    }
    precise int sc_exact_6 = int(x * 2.1 * 3.3);
    switch (sc_exact_6) {
        case 0:
            precise float y = x * 2.0;
            x = y;
    }
    color = vec4(x);
}
