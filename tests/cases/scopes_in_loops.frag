#version 330
// Variables of loop heads and bodies that share names with those outside.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void main() {
    int i = 3;
    float t = wave(v_position);
    for (int i = 0, j = 2; i < j; i++) {
        float t = wave(v_normal) * float(i);
        for (int i = 0; i < 2; i++)
            t += float(i) * 0.125;
        if (t > 0.5) { float t = 0.25; o_color.x += t; }
    }
    { float t = t * 2.0; t += 1.0; i += int(t); }
    o_color = vec4(t, wave(v_position * t), float(i) * 0.125, 1.0);
}
