#version 330
// The last frame, warped: each pixel takes what its point showed there.

layout(location = 0) out vec4 o_color;

void main() {
    vec2 slope = vec2(dFdx(gl_FragCoord.w), dFdy(gl_FragCoord.w));
    o_color = vec4(picture(own_surface(last_place(), last_nearness(), slope)), 1.0);
}
