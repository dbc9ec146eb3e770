#version 330
// Swizzles and elements that are written: a part of the variable stays as it was.
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
    vec3 v = v_normal;
    v.zx = vec2(wave(v_position), wave(v_normal));
    v.y += wave(v_position * 2.0);
    v.yz *= vec2(wave(v), 0.5);
    mat2 m = mat2(wave(v), v.x, v.y, v.z);
    m[1].x = wave(v_position * 3.0);
    m[0] += v.xy;
    v[1] = wave(v * 2.0) + v[2];
    o_color = vec4(m * v.xz, wave(v), v.y);
    o_color.wz = o_color.zw * wave(v_normal * 0.5);
}
