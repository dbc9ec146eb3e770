#version 450 core
in layout(location = 0) centroid smooth vec3 v_p;
in flat layout(location = 1) highp int v_kind;
in noperspective layout(location = 2) sample vec2 v_uv;
out layout(location = 0) vec4 o;

vec3 costly(in const highp vec3 p) {
    highp const float scale = 5.0;
    return exp(sin(p * scale));
}

void main() {
    o = vec4(costly(v_p) + v_uv.xyx, float(v_kind));
}
