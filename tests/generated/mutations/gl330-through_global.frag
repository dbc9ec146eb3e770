#version 330
in vec3 v_position;
out vec4 o_color;
float level = 0.5;
float slope() {
    return fwidth(level);
}
void main() {
    float n = sin(exp(v_position.x) * 3.0);
    level = n;
    o_color = vec4(slope(), v_position.xy, 1.0);
}
