#version 330 core
// Soil between the poppies, darker far away.

in vec3 v_position;
out vec4 o_color;

void main() {
    float rows = 0.5 + 0.5 * sin(v_position.x * 31.0) * sin(v_position.z * 27.0 + v_position.x);
    vec3 soil = mix(vec3(0.09, 0.12, 0.04), vec3(0.17, 0.21, 0.08), rows);
    o_color = vec4(soil, 1.0);
}
