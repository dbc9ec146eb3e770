#version 330 core
struct Surface { vec3 at; vec4 clip; vec2 uv; };
in Surface v_s; in Surface v_t; in vec4 v_rows[3];
float wave(vec3 p) { return sin(p.x * 5.0) * cos(p.y * 3.0) + sin(p.z * 7.0) * cos(p.x * 11.0); }
float wave(vec2 p) { return wave(p.xyx); }
out vec4 o;
void main() {
    float s = 0.0;
    s += wave(v_s.at); // surface
    s += wave(v_s.clip.xy); // screen: v_s
    s += wave(v_s.uv); // surface
    s += wave(v_t.clip.xyz); // screen: v_t
    s += wave(v_t.at); // surface
    s += wave(v_rows[0].xy); // surface
    s += wave(v_rows[1].xy); // screen: v_rows
    s += wave(v_rows[2].xy); // surface
    o = vec4(s);
}
