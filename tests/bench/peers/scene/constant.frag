#version 330
// One colour everywhere, which no compiler knows to be one.
in vec3 v_position;
layout(location = 0) out vec4 o_color;

void main() {
    o_color = vec4(vec3(0.2, 0.6, 0.8) * step(-100.0, v_position), 1.0);
}
