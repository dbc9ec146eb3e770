#version 330
// The remainder takes derivatives of the value: refused, or exact.
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
    float slope = dFdx(a) * 4.0 + dFdy(a);
    float b = wave(v_normal);
    float edge = fwidth(b * 2.0 + v_uv.x);
    float c = wave(v_position * 3.0);
    float d = c * wave(v_normal * 2.0);
    vec3 face = normalize(cross(dFdx(v_position), dFdy(v_position)));
    o_color = vec4(slope + c, smoothstep(0.0, 0.1 + edge, b), d, wave(face) * 0.5 + 0.5);
}
