#version 330
#extension GL_ARB_texture_gather : require
// Each pixel takes its colour from the texels of a smaller picture that lie on its own surface.

uniform vec2 u_scale;  // the size of that picture over the screen's

layout(location = 0) out vec4 o_color;

void main() {
    vec2 place = gl_FragCoord.xy * u_scale;
    float near = gl_FragCoord.w;
    vec2 slope = vec2(dFdx(near), dFdy(near)) / u_scale;  // of the triangle's plane, for each texel
    o_color = vec4(picture(own_surface(place, near, slope), place, near), 1.0);
}
