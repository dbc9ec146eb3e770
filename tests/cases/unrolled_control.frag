#version 330
// What stands in unrolled loops: branches, returns, discards, other loops, arrays, inout arguments.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform sampler2D u_map;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

float march(vec3 p) {
    float depth = 0.0;
    for (int i = 0; i < 4; i++) {
        float h = wave(p + v_normal * depth);
        if (h > 1.2) return depth;
        depth += 0.1 + 0.05 * abs(h);
    }
    return -depth;
}

void shift(inout vec3 p, int by) {
    p.x += 0.25 * float(by) * wave(p);
}

void main() {
    float depth = march(v_position * 0.5);
    vec3 p = v_normal;
    float w[3];
    float sum = 0.0;
    for (int i = 0; i < 3; i++) {
        vec3 q = p * float(i + 1);
        shift(p, i);
        w[i] = wave(q);
        if (i > 0) {
            sum += w[i - 1] * texture(u_map, v_uv * float(i)).r;
        } else {
            float q = wave(p);
            sum -= q * 0.125;
        }
        int n = 0;
        while (n < i) {
            if (n == 1) break;
            sum += 0.03 * float(n + i);
            n++;
        }
        switch (i) {
        case 1:
            sum *= 0.5;
            break;
        default:
            sum += wave(q * 0.3);
        }
        sum += i == 2 ? wave(p * 1.7) : 0.25;
        if (v_uv.x * float(i) > 1.9) discard;
    }
    o_color = vec4(sum, w[0] + w[1] * w[2], depth, 1.0) * 0.25 + 0.1;
}
