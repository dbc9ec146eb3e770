#version 330
// Loops of constant bounds, by counters of every type and in every direction.
in vec3 v_position;
in vec3 v_normal;
uniform float u_time;
out vec4 o_color;

const int COUNT = 3;
const float STEP = 0.3;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

float octaves(vec3 p) {
    float sum = 0.0;
    float scale = 1.0;
    for (int i = 0; i < COUNT; i++) {
        float here = wave(p * scale);
        sum += here * exp(-float(i));
        scale *= 2.03;
    }
    return sum;
}

void main() {
    float a = octaves(v_position);
    // By floats: 0.0, 0.3, 0.6 and 0.90000004.
    for (float t = 0.0; t < 1.0; t += STEP)
        a += wave(v_normal * t);
    // Downwards past zero: 2, 1, 0, and 4294967295 ends it.
    for (uint u = 2u; u < 3u; u--) {
        a += wave(v_position + float(u)) * 0.5;
    }
    float b = octaves(v_normal * 0.7);
    // Two counters, and names that stand for other things outside.
    for (int i = 1, a = 5; i <= 8 && a != 2; i <<= 1, --a) {
        b += wave(v_normal * float(i - a)) / float(a);
    }
    // A triangle.
    float t[4] = float[4](0.1, 0.2, 0.3, 0.4);
    for (int i = -1; i < COUNT; ++i) {
        for (int j = i; j > 0; j = j - 1) {
            t[j] += t[i] * wave(v_position * (float(j) - u_time));
            for (int k = j; k < 2; k += 2) t[k + i - 1] *= 0.5;
        }
    }
    float d = 1.0;
    for (float x = -0.0; x > -2.5; x -= 1.0) {
        d = d * 0.75 + wave(v_position + 1.0 / (x - 0.5));
    }
    // Conditions on counters are decided.
    for (int i = 0; i < 9; i++) {
        if (i == 1) continue;
        if (i < 3 || i == 4)
            d += wave(v_normal * 0.3 + float(i));
        else {
            if (i > 4) {
                d *= 0.5;
                break;
            }
            d -= wave(v_position * 0.3 - float(i));
        }
        a += d * 0.125;
    }
    o_color = vec4(a + t[0], b + t[1], d + t[2], t[3]) * 0.2 + 0.4;
}
