#version 330
// Locals, parameters and inner blocks that hide globals, functions and each other.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float scale = 2.0;

float shade(vec3 wave, float scale) {
    float shade = dot(wave, vec3(0.3, 0.6, 0.1));
    {
        float shade = shade * scale + cos(wave.z * scale);
        scale = shade * 0.5;
    }
    return shade * scale + sin(shade);
}

void main() {
    vec3 v_normal = normalize(v_normal) * scale;
    float scale = wave(v_normal) + scale;
    for (int wave = 0; wave < 2; wave++) {
        float scale = float(wave) + v_uv.x;
        v_normal.x += scale;
    }
    o_color = vec4(shade(v_normal, scale), wave(v_normal * scale), u_time * scale, 1.0);
}
