#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
vec2 kept = vec2(0.5);
float put(inout vec2 x, float y) {
    kept.y = y;
    return sin(y * 3.0);
}
void main() {
    vec3 s = sin(exp(v_position) * 3.0);
    float a = put(kept, v_normal.x);
    o_color = vec4(s, a + kept.y);
}
