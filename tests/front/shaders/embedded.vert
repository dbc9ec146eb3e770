#version 310 es

/* GLSL ES 3.10, a vertex shader. */

precision highp float;
precision mediump sampler2DArray;

layout(location = 0) in vec4 a_position;
layout(location = 1) in uvec2 a_ids;

layout(std140, column_major, binding = 0) uniform Camera {
    mat4 view, projection;
} u_camera;
layout(std430, binding = 1) buffer readonly Bones {
    mat3x4 bones[];
};
uniform highp isampler2D u_ints;
uniform sampler2DArray u_layers;

invariant gl_Position;
flat out uint v_id;
smooth centroid out mediump vec2 v_uv;

int texture2D(int sampler) {
    return sampler;
}

void main() {
    float[2] weights = float[](0.25, 0.75f);
    uint id = a_ids.x >> 1u & 0xFFu;
    switch (int(id)) {
        case 0:
            v_uv = vec2(0.0);
            break;
        default:
            v_uv = vec2(weights[1]);
    }
    v_id = id | a_ids.y ^ ~3U;
    mat3x4 bone = bones[id % 4u];
    vec4 p = vec4(a_position * bone, weights.length());
    gl_Position = u_camera.projection * u_camera.view * p * float(texture2D(1));
    gl_PointSize = 1.0;
}
