#version 330
#extension GL_ARB_texture_gather : require
// What the jittered samples of a frame say of a pixel is blended into what its point showed before.

uniform sampler2D u_color;  // half the size; alpha 0 where nothing was drawn
uniform vec2 u_shift;       // the jitter, in pixels of u_color

layout(location = 0) out vec4 o_color;
layout(location = 1) out vec4 o_history;

const float SHARP = 2.0;  // how weights fall with the square of the distance in screen pixels
const float WIDE = 2.0;   // deviations from the mean that the history may be off

vec3 to_ycocg(vec3 c) {
    return vec3(dot(c, vec3(0.25, 0.5, 0.25)), 0.5 * (c.r - c.b), dot(c, vec3(-0.25, 0.5, -0.25)));
}

vec3 to_rgb(vec3 c) {
    float base = c.x - c.z;
    return vec3(base + c.y, c.x + c.z, base - c.y);
}

void main() {
    // A shift moves the picture: this pixel's centre lies here in the smaller one.
    vec2 at = 0.5 * gl_FragCoord.xy + u_shift;
    ivec2 nearest = ivec2(floor(at));
    ivec2 last = textureSize(u_color, 0) - 1;
    vec4 sum = vec4(0.0);
    vec3 mean = vec3(0.0), squares = vec3(0.0);
    float count = 0.0, best = 0.0;
    for (int i = 0; i < 9; i++) {
        ivec2 texel = nearest + ivec2(i % 3, i / 3) - 1;
        vec2 off = 2.0 * (vec2(texel) + 0.5 - at);
        vec4 found = texelFetch(u_color, clamp(texel, ivec2(0), last), 0);
        vec3 color = to_ycocg(found.rgb);
        float weight = found.a * exp2(-SHARP * dot(off, off));
        sum += weight * vec4(color, 1.0);
        best = max(best, weight);
        mean += found.a * color;
        squares += found.a * color * color;
        count += found.a;
    }
    vec4 shown = what_was_shown();
    vec3 color = sum.rgb / max(sum.a, 1e-30);
    if (shown.a > 0.0) {
        vec3 history = to_ycocg(shown.rgb);
        if (count > 0.0) {
            mean /= count;
            vec3 box = WIDE * sqrt(max(squares / count - mean * mean, 0.0));
            // Clipped towards the mean, as a line to a box, so that hues stay what they are.
            vec3 off = history - mean;
            vec3 units = abs(off) / max(box, 1e-4);
            history = mean + off / max(1.0, max(units.x, max(units.y, units.z)));
        }
        color = mix(history, color, best);
    }
    color = clamp(to_rgb(color), 0.0, 1.0);
    o_color = vec4(color, 1.0);
    o_history = vec4(16.0 * gl_FragCoord.w, color);
}
