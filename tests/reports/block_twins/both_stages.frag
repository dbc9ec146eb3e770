#version 430
in vec3 v_p;
in vec3 v_n;
layout(location = 0) out vec4 o;
layout(std140, binding = 2) uniform Camera {
    mat4 view;
    mat4 projection;
    vec4 tint;
} camera;
layout(std140, binding = 0) uniform Material {
    vec4 gain;
    float bias;
};
vec3 costly(vec3 p) {
    vec3 s = sin(p * 5.0);
    for (int i = 0; i < 3; i++)
        s = exp(sin(s.yzx * 2.0 + p * gain.x));
    return s * 0.3 + bias;
}
void main() { o = vec4(costly(v_p) * max(v_n.z, 0.2), 1.0) * camera.tint; }
