#version 330
// Haze that thins upwards. Nothing here is worth a cache.

in vec3 v_world;  // world space

layout(location = 0) out vec4 o_color;

void main() {
    float height = clamp(v_world.y / 9.0, 0.0, 1.0);
    vec3 color = mix(vec3(0.62, 0.60, 0.58), vec3(0.20, 0.34, 0.56), sqrt(height));
    o_color = vec4(sqrt(1.0 - exp2(-1.7 * color)), 1.0);
}
