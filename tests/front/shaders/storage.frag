#version 460 core
#extension GL_EXT_demote_to_helper_invocation : enable

// What came after 3.30: memory, doubles, arrays of arrays, lists in braces.

layout(early_fragment_tests) in;
layout(std430, row_major) buffer;

precision highp float;

struct Range {
    float near, far;
};
struct Light {
    vec3 place;
    Range range;
};

layout(std430, binding = 0) buffer coherent restrict readonly Lights {
    uint count;
    mat4 turn[2];
    vec4 lights[];
} b_lights;

layout(binding = 1) buffer volatile Totals {
    writeonly uint total;
} b_totals[2][3];

layout(shared) uniform Plain {
    vec4 u_plain;
};

layout(std140, binding = 1 + 1) uniform Packed {
    layout(offset = 16) vec4 value;
} u_packed;

layout(rgba8, binding = 0) uniform restrict writeonly image2D u_out;
layout(r32ui) uniform coherent uimage2DArray u_counts;
layout(binding = 0, offset = 4) uniform atomic_uint u_hits;
layout(binding = 3) uniform samplerCubeArrayShadow u_shadow;
layout(binding = 4) uniform isampler2DMSArray u_samples;

sample in vec2 v_sample;
noperspective centroid in vec2 v_centre;
flat in dvec2 v_exact;
in Surface {
    layout(location = 5) vec3 normal;
    layout(location = 6) flat int id;
} v_surface;

layout(origin_upper_left, pixel_center_integer) in vec4 gl_FragCoord;
layout(depth_greater) out float gl_FragDepth;
layout(location = 0, index = 0) out vec4 o_color;

const int k_size = 2;
float weights[k_size][3] = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
const mat2 k_turn = {{1.0, 0.0}, {0.0, 1.0,},};
Light light = {vec3(1.0), {0.1, 10.0}};

layout(r32f) uniform image2D u_images[2];

double exact(double x, const in dvec3[2] y, out dmat2x3 z) {
    z = dmat2x3(1.0lf);
    return x * 2.0LF + y[1].x + 1e-3lf;
}

float texture2D(float sampler, float texture) {
    float packed = 1.0, row_major, column_major = sampler;
    return packed + texture + column_major;
}

void main() {
    precise float sum = 0.0, rest;
    precise rest;
    const float[2][2] table = float[2][2](float[](1.0, 2.0), float[2](3.0, 4.0));
    for (int i = 0; i < table.length(); ++i)
        sum += table[i][table[0].length() - 1] * weights[i][2];
    dmat2x3 rows;
    sum += float(exact(1.0lf, dvec3[2](dvec3(1.0), dvec3(2.0)), rows));
    if (sum < 0.0)
        demote;
    while (bool more = sum < 0.0)
        sum++;
    imageStore(u_out, ivec2(gl_FragCoord.xy), vec4(sum));
    gl_FragDepth = gl_FragCoord.z;
    o_color = b_lights.turn[1] * vec4(sum, texture2D(1.0, 2.0), light.range.near, 0x1FU);
}
