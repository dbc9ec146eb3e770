#version 120
// GLSL 1.20 with a discard, an early return and gl_FragData.
varying vec3 v_position;
varying vec3 v_normal;
varying vec2 v_uv;
uniform sampler2D u_map;
uniform float u_time;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


void main() {
    float a = wave(v_position);
    if (texture2D(u_map, v_uv).x < 0.3)
        discard;
    gl_FragData[0] = vec4(a, wave(v_normal), 0.5, 1.0);
    if (a > 0.5)
        return;
    gl_FragData[0].z = wave(v_position * 2.0);
}
