#version 330
// The colour output is read, changed in parts, and written by a function.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void fade(float by) { o_color.rgb *= by; o_color.a = by; }

void main() {
    o_color = vec4(wave(v_position));
    o_color += vec4(0.25, wave(v_normal), 0.0, 0.0);
    float level = dot(o_color.rgb, vec3(0.3, 0.6, 0.1));
    fade(wave(v_position * 2.0) + level);
    if (o_color.a > 0.5)
        o_color.g += 0.125;
}
