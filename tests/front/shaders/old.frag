#version 100
#extension GL_OES_standard_derivatives : enable

// GLSL ES 1.00, whose words are names in no other version.

precision mediump float;
precision lowp int;

varying vec2 v_uv;
invariant varying highp vec3 v_normal;
uniform sampler2D u_image;
uniform samplerCube u_sky;
uniform lowp vec4 u_tints[3];

struct Light {
    lowp vec3 color;
    mediump float power;
};

const int uint = 3;
float sample, buffer, texture, precise, layout, shared, smooth, mat2x3, isampler2D;

lowp vec3 centroid(const in highp vec2 image1D, Light Light, out vec2, inout mediump mat3 layout);
float round(void);

float round(void) {
    return 1. + .5 + 1e3;
}

lowp vec3 centroid(const in highp vec2 patch, Light Light, out vec2 o, inout mediump mat3 layout) {
    o = patch;
    layout[1].zyx *= 2.0;
    return Light.color * layout[2][0];
}

void main() {
    mediump mat3 m = mat3(1.0);
    vec2 uv;
    lowp vec3 c = centroid(v_uv, Light(vec3(1.0), 0.5), uv, m);
    for (int i = 0; i < uint; ++i) {
        if (uv.x > 0.5)
            continue;
        c += u_tints[i].rgb;
    }
    gl_FragColor = vec4(texture2D(u_image, v_uv).stp + c * textureCube(u_sky, v_normal).rgb, round());
    gl_FragColor.a = dFdx(uv.x) + sample;
}
