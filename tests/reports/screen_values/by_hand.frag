#version 330 core
in vec2 v_screen; in vec2 v_parts; in vec3 v_eye; in float v_distance; in vec2 v_uv;
float wave(vec3 p) { return sin(p.x * 5.0) * cos(p.y * 3.0) + sin(p.z * 7.0) * cos(p.x * 11.0); }
float wave(vec2 p) { return wave(p.xyx); }
float wave(float p) { return wave(vec3(p, p * 2.0, p * 3.0)); }
out vec4 o;
void main() {
    float s = 0.0;
    s += wave(v_screen); // screen: v_screen
    s += wave(v_parts.y); // screen: v_parts
    s += wave(v_parts.x); // surface
    s += wave(v_eye); // surface
    s += wave(v_distance); // surface
    s += wave(v_uv); // surface
    o = vec4(s);
}
