#version 400
// Flat, centroid and noperspective inputs; precise and invariant variables.
flat in vec3 v_flat;
centroid in vec3 v_centre;
noperspective in vec2 v_linear;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

precise float wave_unused;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void main() {
    precise float a = wave(vec3(v_linear, 0.5));
    float b = wave(v_flat) * a;
    float c = wave(v_centre) + a;
    o_color = vec4(a, b, c, wave(v_flat * a));
}
