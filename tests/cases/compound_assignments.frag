#version 330
// Compound assignments of every form: what they leave in their target is a value.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform sampler2D u_map;
uniform float u_time;
out vec4 o_color;

struct Sum {
    vec3 light;
    float weights[3];
};

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

float counted(vec3 p, inout int calls) {
    calls += 1;
    return wave(p) * float(calls);
}

void main() {
    vec3 c = vec3(0.1);
    c += wave(v_position);
    c += texture(u_map, v_uv).rgb;
    c -= 0.25 * wave(v_normal), c /= 1.0 + abs(wave(c));
    mat3 m = mat3(c, v_normal, v_position);
    m *= mat3(0.5, 0.1, 0.0, 0.2, 0.4, 0.1, 0.0, 0.3, 0.6);
    m[1] *= m;
    m[2].zx += m[0].xy * wave(c);
    int n = int(8.0 * wave(v_position));
    n <<= 2, n |= 1;
    n ^= n >> 1;
    n %= 7;
    uint bits = uint(n & 15);
    bits <<= n & 3;
    float mean = 0.5;
    mean += n;  // an int, which becomes a float
    mean *= 1 / 2.0;
    Sum sum = Sum(c, float[3](wave(c), 0.2, 0.3));
    sum.light *= m;
    sum.weights[n & 1] -= sum.weights[2] * mean;
    int at = 0;
    sum.weights[at++] += wave(v_normal * 2.0);  // a side effect in the target
    int calls = 0;
    mean += counted(v_normal, calls);  // and in the value
    calls += int(counted(c, calls));   // which writes what the target reads
    if (c.x > 0.3) {
        c.zy *= vec2(wave(v_position * 3.0), 0.5);
        mean -= wave(c);
    } else
        c.x += 0.5, mean += wave(c * 0.5);
    switch (int(bits) & 1) {
    case 0:
        mean *= wave(v_normal * 1.5);
        break;
    default:
        mean += 0.25, c *= 0.75;
    }
    for (int i = 0; i < 3; i++, c += 0.01) {
        c *= 1.0 + 0.1 * wave(c * float(i));
    }
    float a, b;
    a = b = wave(c);
    a += b *= 0.5;  // only the outer one is a statement
    o_color = vec4(sum.light + c * 0.1 + float(bits) * 0.01, 1.0);
    o_color.rg += vec2(mean, a) * 0.1;
    o_color.b *= sum.weights[0] + sum.weights[1] + float(calls) * 0.05;
}
