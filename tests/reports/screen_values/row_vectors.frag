#version 440 core
layout(location = 2) in vec3 clip; layout(location = 1) in vec3 at; layout(location = 0) in vec4 last;
float wave(vec3 p) { return sin(p.x * 5.0) * cos(p.y * 3.0) + sin(p.z * 7.0) * cos(p.x * 11.0); }
float wave(vec2 p) { return wave(p.xyx); }
float wave(float p) { return wave(vec3(p, p * 2.0, p * 3.0)); }
out vec4 o;
void main() {
    float s = 0.0;
    s += wave(last.xyz); // screen: last
    s += wave(at); // surface
    s += wave(clip); // surface
    o = vec4(s);
}
