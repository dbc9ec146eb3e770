#version 330
// Values of the fragment's place on the screen and of its face.
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
    float a = wave(v_position);
    float b = a * fract(gl_FragCoord.x * 0.25);
    float c = gl_FrontFacing ? wave(v_normal) : -wave(-v_normal);
    float d = wave(vec3(gl_FragCoord.xy * 0.01, 0.0)) + a;
    vec3 n = normalize(gl_FrontFacing ? v_normal : -v_normal);
    o_color = vec4(b, c, d, wave(n));
}
