#version 330
uniform sampler2D u_map;
in vec2 v_uv;
out vec4 o_color;

//// What was spelled out reads as the user wrote it.
struct Sum {
    vec3 light;
    float parts[3];
};
float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}
float writes(out float x) {
    x = 1.0;
    return 0.5;
}
int cheap() {
    return 1;
}
float g;
float changes_g() {
    g = 2.0;
    return 1.0;
}
float a, b;
vec3 v;
mat3 m;
int i, j;
uint u;
Sum s;
float t[4];
void main() {
    a += wave(b);
    a *= b - 1.0;
    v.zx /= b;
    m *= m;
    v *= m;
    m[1][2] -= 1.0;
    i %= 3;
    i <<= j & 3;
    u ^= u >> 3u;
    a += i;
    s.parts[i + 1] += b;
    g += wave(g);
    if (a > b)
        v.x += b;
    a += b, b = a, v *= a;
    if (a > b)
        a += 1.0, b += a;
    o_color = vec4(1.0);
}
//// becomes
#version 330

uniform sampler2D u_map;
in vec2 v_uv;
out vec4 o_color;

struct Sum {
    vec3 light;
    float parts[3];
};

float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}

float writes(out float x) {
    x = 1.0;
    return 0.5;
}

int cheap() {
    return 1;
}

float g;

float changes_g() {
    g = 2.0;
    return 1.0;
}

float a, b;
vec3 v;
mat3 m;
int i, j;
uint u;
Sum s;
float t[4];

void main() {
    a += wave(b);
    a *= b - 1.0;
    v.zx /= b;
    m *= m;
    v *= m;
    m[1][2] -= 1.0;
    i %= 3;
    i <<= j & 3;
    u ^= u >> 3u;
    a += i;
    s.parts[i + 1] += b;
    g += wave(g);
    if (a > b)
        v.x += b;
    a += b;
    b = a;
    v *= a;
    if (a > b) {
        a += 1.0;
        b += a;
    }
    o_color = vec4(1.0);
}
