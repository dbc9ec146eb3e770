#version 330
// Of the texels around a pixel in a smaller picture those count that lie on the pixel's own surface:
// bilinear weights times what the depths say.

uniform sampler2D u_color;
uniform sampler2D u_depth;  // window depths of the smaller picture
uniform vec2 u_scale;       // its size over that of the screen

layout(location = 0) out vec4 o_color;

const float EDGE = 0.01;  // of the nearness: what lies so far off the surface's plane counts little

void main() {
    vec2 at = gl_FragCoord.xy * u_scale - 0.5;
    ivec2 low = ivec2(floor(at));
    ivec2 last = textureSize(u_color, 0) - 1;
    float here = gl_FragCoord.w;
    vec2 slope = vec2(dFdx(here), dFdy(here)) / u_scale;  // of the triangle's plane, for each texel
    vec4 sum = vec4(0.0);
    float best = 1e9;
    vec4 nearest = vec4(0.0);
    for (int i = 0; i < 4; i++) {
        ivec2 texel = low + ivec2(i & 1, i >> 1);
        vec2 off = vec2(texel) - at;
        texel = clamp(texel, ivec2(0), last);
        float there = nearness(texelFetch(u_depth, texel, 0).r);
        float apart = abs(there - here - dot(slope, off)) / (EDGE * here);
        vec3 color = texelFetch(u_color, texel, 0).rgb;
        vec2 tent = 1.0 - abs(off);
        float weight = tent.x * tent.y * exp2(-apart * apart);
        sum += weight * vec4(color, 1.0);
        if (apart < best) {
            best = apart;
            nearest = vec4(color, 1.0);
        }
    }
    // A surface that the smaller picture has lost takes the nearest one's colour.
    if (sum.a < 0.01) {
        sum = nearest;
    }
    o_color = vec4(sum.rgb / sum.a, 1.0);
}
