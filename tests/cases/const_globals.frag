#version 330
// Constant globals, and locals that are as constant without the word.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

const float PI = 3.14159265;
const vec3 AXIS = normalize(vec3(1.0, 2.0, 3.0));
const float TABLE[3] = float[3](0.2, 0.5, PI / 8.0);
const int COUNT = 3;

void main() {
    const float step = PI / float(COUNT);
    float fixedPoint = sin(step) * 2.0;
    float sum = 0.0;
    for (int i = 0; i < COUNT; i++)
        sum += TABLE[i] * cos(fixedPoint);
    float a = dot(v_position, AXIS) * PI + sin(v_uv.x * step);
    float b = a * TABLE[1] + cos(v_uv.y * TABLE[2]) * sum;
    o_color = vec4(a, b, fixedPoint * sin(a * b), 1.0);
}
