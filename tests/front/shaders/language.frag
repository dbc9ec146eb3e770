#version 330 core
#extension GL_ARB_shading_language_420pack : disable
#pragma optimize(on)

/* Every construct of the language once or more,
   each in a form that is valid GLSL 3.30. */

#define PI 3.14159265
#define TAU (2.0 * PI)
#define STEPS 4

precision highp float;
precision mediump int;

struct Ray {
    vec3 origin, direction;
    float range[2];
};

struct Scene {
    Ray rays[2];
    mat3 turn;
} g_scene;

struct {
    float a;
} g_plain;

layout(std140) uniform Camera {
    mat4 view;
    layout(row_major) mat4 projection;
} u_camera;

layout(std140, row_major) uniform Lights {
    vec4 u_lights[4];
};

uniform sampler2D u_image, u_images[2];
uniform sampler2DShadow u_shadow;
uniform isampler2D u_ints;
uniform samplerCube u_sky;
uniform float u_time = 1.0;

smooth in vec3 v_position;
flat in int v_id;
noperspective centroid in vec2 v_uv;
in Surface {
    vec3 normal;
} v_surface;

layout(location = 0) out vec4 o_color;
layout(location = 1, index = 0) out vec4 o_other;

const float k_weights[3] = float[3](0.25, 0.5, 0.25);
const vec3[] k_axes = vec3[](vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
float g_total = 0.0, g_count;

float prototype(const in float, out vec2 pairs[2], inout int);
void nothing(void);

float prototype(const in float x, out vec2 pairs[2], inout int n) {
    pairs[0] = vec2(x);
    pairs[1] = pairs[0].yx;
    n += 1;
    return pairs[1].x;
}

void nothing(void) {
    ;
}

float hidden(Ray Ray) {
    return Ray.range[0] + Ray.range.length();
}

Ray bounce(in Ray ray, vec3 n) {
    Ray Ray = Ray(ray.origin, reflect(ray.direction, n), float[2](0.0, 1.0));
    Ray.origin += 1e-3 * n;
    return Ray;
}

int bits(int x, uint y) {
    int a = ~x & 0xFF | 017 ^ 3;
    uint b = y << 2u >> 1u;
    a <<= 1;
    a >>= 2;
    a &= 7;
    a ^= 1;
    a |= 8;
    a %= 5;
    b = b % 3u;
    return a + int(b);
}

bool logic(float x) {
    bool p = x < 1.0 && x > -1.0 || x <= .5 ^^ x >= 2.;
    return !p != (x == 1.5e+2);
}

vec4 branches(float x) {
    if (x > 0.0)
        if (x > 1.0)
            x -= 1.0;
        else
            x += 1.0;
    if (x > 2.0) {
        x *= 2.0;
    } else if (x > 3.0)
        x /= 2.0;
    else {
        x = -x;
    }
    switch (int(x)) {
        case 0:
        case 1:
            x = 2.0;
            break;
        case 1 + 1: {
            x = 3.0;
        }
        default:
            x = 4.0;
    }
    return vec4(x);
}

float loops() {
    float sum = 0.0;
    for (int i = 0, j = STEPS; i < j; i++, --j) {
        if (i == 2)
            continue;
        sum += k_weights[i % 3];
    }
    for (;;)
        break;
    for (int i = 0; bool more = i < 3; ++i)
        sum += more ? 1.0 : 0.0;
    while (bool go = sum < 0.0)
        sum++;
    while (sum > 100.0) {
        sum--;
    }
    do
        sum *= 0.5;
    while (sum > 10.0);
    do {
        float sum = sum;
        g_total += sum;
    } while (false);
    return sum;
}

void main() {
    vec2 pairs[2];
    int n = 1;
    float got = prototype(u_time, pairs, n);
    Ray ray = bounce(Ray(v_position, vec3(0.0, 0.0, -1.0), float[](0.0, 1.0)), v_surface.normal);
    float light = hidden(ray) * TAU - -got - (n > 0 ? 1.0 : n < -1 ? 2.0 : 3.0);
    mat4x3 wide = mat4x3(1.0);
    wide[1].zyx = wide[0];
    (wide)[2][0] = float(bits(n, 3u)), nothing();
    vec4 texel = textureLod(u_image, v_uv, 0.0) + texelFetch(u_images[1], ivec2(gl_FragCoord.xy), 0);
    if (!logic(light))
        discard;
    o_color = texel * light + branches(loops()) * k_axes.length();
    o_other = u_camera.projection * u_lights[0];
    o_other.x = n = 3, g_scene.turn[0][0];
    return;
}
