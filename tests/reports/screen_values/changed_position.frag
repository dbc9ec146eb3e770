#version 330 core
in vec4 v_clip; in vec3 v_world; in vec4 v_plain;
float wave(vec3 p) { return sin(p.x * 5.0) * cos(p.y * 3.0) + sin(p.z * 7.0) * cos(p.x * 11.0); }
float wave(vec2 p) { return wave(p.xyx); }
float wave(float p) { return wave(vec3(p, p * 2.0, p * 3.0)); }
out vec4 o;
void main() {
    float s = 0.0;
    s += wave(v_clip.xyz); // screen: v_clip
    s += wave(v_plain.xyz); // screen: v_plain
    s += wave(v_world); // surface
    o = vec4(s);
}
