#version 330
// The last frame, warped: each pixel takes what its point showed there.

uniform sampler2D u_color;  // of the last frame
uniform sampler2D u_depth;  // its window depths

layout(location = 0) out vec4 o_color;

const float SAME = 0.01;  // of the nearness: what lies so far off the plane is another surface

void main() {
    vec2 at = last_place() - 0.5;
    ivec2 low = ivec2(floor(at));
    ivec2 last = textureSize(u_color, 0) - 1;
    float expected = last_nearness();
    vec2 slope = vec2(dFdx(gl_FragCoord.w), dFdy(gl_FragCoord.w));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; i++) {
        ivec2 texel = low + ivec2(i & 1, i >> 1);
        vec2 off = vec2(texel) - at;
        texel = clamp(texel, ivec2(0), last);
        float there = nearness(texelFetch(u_depth, texel, 0).r);
        vec2 tent = 1.0 - abs(off);
        float weight = abs(there - expected - dot(slope, off)) < SAME * expected
            ? tent.x * tent.y : 0.0;
        sum += weight * vec4(texelFetch(u_color, texel, 0).rgb, 1.0);
    }
    // It was hidden: look around for what fits best, ever farther away.
    float best = 1e9;
    for (int ring = 1; ring <= 16 && sum.a < 1e-3; ring *= 2) {
        for (int i = 0; i < 8; i++) {
            int side = i < 4 ? i : i + 1;
            ivec2 texel = ivec2(at + 0.5) + ring * (ivec2(side % 3, side / 3) - 1);
            texel = clamp(texel, ivec2(0), last);
            float apart = abs(nearness(texelFetch(u_depth, texel, 0).r) - expected);
            if (apart < best) {
                best = apart;
                sum = vec4(texelFetch(u_color, texel, 0).rgb, 0.0);
            }
        }
        // Only what is near enough ends the search; the best of all is the last resort.
        sum.a = best < 0.05 * expected ? 1.0 : 0.0;
    }
    o_color = vec4(sum.a > 0.0 ? sum.rgb / sum.a : sum.rgb, 1.0);
}
