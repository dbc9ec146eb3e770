#version 330 core
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform float u_a;
out vec4 color;
float seen(float x) {
    if (sin(3.0 * x) > 0.6) discard;
    return x;
}
float wave(float x) { return sin(3.0 * x) * sin(5.0 * v_position.x); }
void main() {
    float y = wave(seen(v_position.x));
    float z = wave(seen(v_position.y)) + v_uv.x;
    color = vec4(y, z, v_normal.x, u_a);
}
