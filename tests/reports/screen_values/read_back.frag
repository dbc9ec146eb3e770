#version 330 core
in vec2 v_screen; in vec4 v_packed; in vec3 v_half; in float v_depth; in vec2 v_near;
in Surface { vec3 at; vec4 clip; vec2 uv; } s_in;
float inside() { return s_in.clip.y; }
float below() { return s_in.at.y; }
float wave(vec3 p) { return sin(p.x * 5.0) * cos(p.y * 3.0) + sin(p.z * 7.0) * cos(p.x * 11.0); }
float wave(vec2 p) { return wave(p.xyx); }
float wave(float p) { return wave(vec3(p, p * 2.0, p * 3.0)); }
out vec4 o;
void main() {
    float s = 0.0;
    s += wave(v_screen); // screen: v_screen
    s += wave(v_packed.xy); // surface
    s += wave(v_packed.zw); // screen: v_packed
    s += wave(v_packed[1]); // surface
    s += wave(v_half.xzx); // surface
    s += wave(v_half); // screen: v_half
    s += wave(v_depth); // surface
    s += wave(v_near); // surface
    s += wave(s_in.at); // surface
    s += wave(s_in.uv); // surface
    s += wave(s_in.clip.xy / s_in.clip.w); // screen: clip
    s += wave(s_in.clip.z / s_in.clip.w); // surface
    s += wave(inside()); // screen: clip
    s += wave(below()); // surface
    vec3 told = vec3(s_in.clip.x, 0.0, 0.0);
    s += wave(told); // screen: clip
    o = vec4(s);
}
