#version 330
#extension GL_ARB_texture_gather : require
// The last frame, warped: each pixel takes what its point showed there.

layout(location = 0) out vec4 o_color;

void main() {
    vec2 place = last_place();
    float near = last_nearness();
    vec2 slope = vec2(dFdx(gl_FragCoord.w), dFdy(gl_FragCoord.w));
    o_color = vec4(picture(own_surface(place, near, slope), place, near), 1.0);
}
