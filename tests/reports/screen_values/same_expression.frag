#version 330 core
in vec4 v_clip; in vec4 v_moved; in vec3 v_ndc; in vec4 v_through;
in vec3 v_world; in vec3 v_view; in vec3 v_normal; in vec4 v_shadow; in vec4 v_second;
in float v_distance; in vec3 v_facing; in vec3 v_along;
float wave(vec3 p) { return sin(p.x * 5.0) * cos(p.y * 3.0) + sin(p.z * 7.0) * cos(p.x * 11.0); }
float wave(vec2 p) { return wave(p.xyx); }
float wave(float p) { return wave(vec3(p, p * 2.0, p * 3.0)); }
out vec4 o;
void main() {
    float s = 0.0;
    s += wave(v_clip.xyz); // screen: v_clip
    s += wave(v_moved.xyz); // screen: v_moved
    s += wave(v_ndc.xy); // screen: v_ndc
    s += wave(v_ndc.z); // surface
    s += wave(v_through.xy); // screen: v_through
    s += wave(v_world); // surface
    s += wave(v_view); // surface
    s += wave(v_normal); // surface
    s += wave(v_shadow.xyz / v_shadow.w); // surface
    s += wave(v_second.xyz / v_second.w); // surface
    s += wave(v_distance); // surface
    s += wave(v_facing); // surface
    s += wave(v_along); // surface
    o = vec4(s);
}
