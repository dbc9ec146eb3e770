#version 450 core
layout(location = 0) in vec3 a_position;
out layout(location = 0) centroid smooth vec3 v_p;
out flat layout(location = 1) highp int v_kind;
layout(location = 2) out noperspective sample precise vec2 v_uv;
uniform highp mat4 u_vp;

void main() {
    v_p = a_position;
    v_kind = 3;
    v_uv = a_position.xy;
    gl_Position = u_vp * vec4(a_position, 1.0);
}
