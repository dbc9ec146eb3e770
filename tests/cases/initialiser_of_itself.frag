#version 330
// A local that is initialised by the global it hides, and several to a declaration.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float x = 0.5;

void main() {
    float x = x * 2.0 + wave(v_position), y = x * wave(v_normal), z = wave(vec3(x, y, 0.0));
    vec2 a = v_uv, b[2] = vec2[2](a, a * x), c = b[1] + y;
    o_color = vec4(x * y, z, c);
}
