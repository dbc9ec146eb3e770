#version 400 core
noperspective in vec3 v_edge; in vec2 v_uv; centroid in vec2 v_middle; flat in vec3 v_flat;
noperspective in vec4 v_carried;
in Lines { noperspective vec3 far; vec3 near; } lines;
uniform sampler2D u_map;
float wave(vec3 p) { return sin(p.x * 5.0) * cos(p.y * 3.0) + sin(p.z * 7.0) * cos(p.x * 11.0); }
float wave(vec2 p) { return wave(p.xyx); }
float wave(float p) { return wave(vec3(p, p * 2.0, p * 3.0)); }
out vec4 o;
void main() {
    float s = 0.0;
    s += wave(v_edge); // screen: v_edge
    s += wave(v_carried.w); // screen: v_carried
    s += wave(v_uv); // surface
    s += wave(v_middle); // surface
    s += wave(v_flat); // surface
    s += wave(lines.far); // screen: far
    s += wave(lines.near); // surface
    s += wave(textureQueryLod(u_map, v_uv)); // screen: textureQueryLod
    s += wave(interpolateAtOffset(v_uv, vec2(0.25))); // screen: interpolateAtOffset
    s += wave(interpolateAtCentroid(v_uv)); // screen: interpolateAtCentroid
    s += wave(interpolateAtSample(v_uv, 0)); // screen: interpolateAtSample
    o = vec4(s);
}
