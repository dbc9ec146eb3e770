#version 330
// Of what a pixel shows: x/w, y/w and 1/w in the frame before, the object's number; and 1/w.
in vec4 v_before;
flat in float v_number;
layout(location = 0) out vec4 o_color;
layout(location = 1) out float o_mask;

void main() {
    o_color = vec4(v_before.xy / v_before.w, 1.0 / v_before.w, v_number);
    o_mask = gl_FragCoord.w;
}
