#version 330 core
in vec2 v_uv; in vec4 v_clip;
float wave(vec3 p) { return sin(p.x * 5.0) * cos(p.y * 3.0) + sin(p.z * 7.0) * cos(p.x * 11.0); }
float wave(vec2 p) { return wave(p.xyx); }
float wave(float p) { return wave(vec3(p, p * 2.0, p * 3.0)); }
out vec4 o;
void main() {
    float s = 0.0;
    s += wave(v_uv); // surface
    s += wave(v_clip.xyz); // surface
    o = vec4(s);
}
