#version 330 core
smooth centroid in vec3 v_p;
flat in highp int v_kind;
invariant centroid in vec2 v_uv;
layout(location = 0) out highp vec4 o;

vec3 costly(const in highp vec3 p) {
    const mediump float scale = 5.0;
    return exp(sin(p * scale));
}

void main() {
    o = vec4(costly(v_p) + v_uv.xyx, float(v_kind));
}
