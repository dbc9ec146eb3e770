#version 330 core
layout(location = 0) in vec3 a_position;
smooth centroid out vec3 v_p;
flat out highp int v_kind;
invariant centroid out vec2 v_uv;
uniform mat4 u_vp;

void main() {
    v_p = a_position;
    v_kind = 3;
    v_uv = a_position.xy;
    gl_Position = u_vp * vec4(a_position, 1.0);
}
