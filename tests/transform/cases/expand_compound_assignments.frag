#version 330
uniform sampler2D u_map;
in vec2 v_uv;
out vec4 o_color;

//// Whole statements are spelled out.
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
    a = a + wave(b);
    a = a * (b - 1.0);
    v.zx = v.zx / b;
    m = m * m;
    v = v * m;
    m[1][2] = m[1][2] - 1.0;
    i = i % 3;
    i = i << (j & 3);
    u = u ^ u >> 3u;
    a = a + i;
    s.parts[i + 1] = s.parts[i + 1] + b;
    g = g + wave(g);
    if (a > b)
        v.x = v.x + b;
    a = a + b;
    b = a;
    v = v * a;
    if (a > b) {
        a = a + 1.0;
        b = b + a;
    }
    o_color = vec4(1.0);
}

//// What would be evaluated twice stays, and so do loops.
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
    t[i++] += 1.0;
    t[cheap()] += 1.0;
    t[int(texture(u_map, v_uv).x)] += 1.0;
    a += writes(b);
    a += changes_g();
    a += b *= 2.0;
    a = b += 1.0;
    for (i = 0; i < 3; i += 1)
        a += 1.0;
    while (a < 1.0)
        a += 0.5;
    a++;
    a = a + 1.0;
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
    t[i++] += 1.0;
    t[cheap()] += 1.0;
    t[int(texture(u_map, v_uv).x)] += 1.0;
    a += writes(b);
    a += changes_g();
    a += b *= 2.0;
    a = b += 1.0;
    for (i = 0; i < 3; i += 1)
        a += 1.0;
    while (a < 1.0)
        a += 0.5;
    a++;
    a = a + 1.0;
    o_color = vec4(1.0);
}
