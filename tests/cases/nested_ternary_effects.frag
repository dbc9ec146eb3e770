#version 330
// Side effects in the arms of nested ?:.
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
    float x = 1.0;
    float y = wave(v_position);
    float z = v_uv.x > 0.5 ? (x += wave(v_normal)) : v_uv.y > 0.5 ? (y *= 2.0) : (x = y, y + 0.5);
    float w = wave(v_position + x) + wave(v_normal + y);
    o_color = vec4(x, y, z, w);
}
