#version 330
// Haze at the horizon, blue above.

in vec3 v_world;  // world space

layout(location = 0) out vec4 o_color;

void main() {
    float height = clamp(v_world.y / 60.0, 0.0, 1.0);
    vec3 color = mix(vec3(0.60, 0.62, 0.62), vec3(0.14, 0.30, 0.58), sqrt(height));
    o_color = vec4(sqrt(1.0 - exp2(-1.5 * color)), 1.0);
}
