#version 330
// What the jittered samples of a frame say of a pixel is blended into what its point showed before.

uniform sampler2D u_color;    // half the size; alpha 0 where nothing was drawn
uniform sampler2D u_history;  // the last picture; alpha: 16/w
uniform vec2 u_shift;         // the jitter, in pixels of u_color
uniform int u_begins;         // 1: there is no last picture

layout(location = 0) out vec4 o_color;
layout(location = 1) out vec4 o_history;

const float SAME = 0.01;   // of the nearness: what is so far off is another surface
const float SHARP = 2.0;   // falls off with the square of a sample's distance, in screen pixels
const float BLEND = 0.25;  // the share of a sample upon the pixel's very centre
const float WIDE = 1.5;    // deviations from the mean that the history may be off

vec3 to_ycocg(vec3 c) {
    return vec3(dot(c, vec3(0.25, 0.5, 0.25)), 0.5 * (c.r - c.b), dot(c, vec3(-0.25, 0.5, -0.25)));
}

vec3 to_rgb(vec3 c) {
    float base = c.x - c.z;
    return vec3(base + c.y, c.x + c.z, base - c.y);
}

// The history by a Catmull-Rom filter in five bilinear fetches (Jimenez 2016), place in pixels.
vec3 sharp_history(vec2 place) {
    vec2 centre = floor(place - 0.5) + 0.5;
    vec2 f = place - centre;
    vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f));
    vec2 w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f));
    vec2 w3 = f * f * (-0.5 + 0.5 * f);
    vec2 w12 = w1 + w2;
    vec2 pixel = 1.0 / u_size;
    vec2 t0 = (centre - 1.0) * pixel, t12 = (centre + w2 / w12) * pixel, t3 = (centre + 2.0) * pixel;
    vec4 sum = vec4(textureLod(u_history, vec2(t12.x, t0.y), 0.0).rgb, 1.0) * (w12.x * w0.y)
        + vec4(textureLod(u_history, vec2(t0.x, t12.y), 0.0).rgb, 1.0) * (w0.x * w12.y)
        + vec4(textureLod(u_history, t12, 0.0).rgb, 1.0) * (w12.x * w12.y)
        + vec4(textureLod(u_history, vec2(t3.x, t12.y), 0.0).rgb, 1.0) * (w3.x * w12.y)
        + vec4(textureLod(u_history, vec2(t12.x, t3.y), 0.0).rgb, 1.0) * (w12.x * w3.y);
    return sum.rgb / sum.a;
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
    vec2 place = last_place();
    float there = textureLod(u_history, place / u_size, 0.0).a;
    float expected = 16.0 * last_nearness();
    bool known = u_begins == 0 && abs(there - expected) < SAME * expected
        && place == clamp(place, vec2(0.0), u_size);
    vec3 color = sum.rgb / max(sum.a, 1e-6);
    if (known) {
        vec3 history = to_ycocg(sharp_history(place));
        if (count > 0.0) {
            mean /= count;
            vec3 box = WIDE * sqrt(max(squares / count - mean * mean, 0.0));
            // Clipped towards the mean, as a line to a box, so that hues stay what they are.
            vec3 off = history - mean;
            vec3 units = abs(off) / max(box, 1e-4);
            history = mean + off / max(1.0, max(units.x, max(units.y, units.z)));
        }
        color = mix(history, color, BLEND * best);
    }
    color = clamp(to_rgb(color), 0.0, 1.0);
    o_color = vec4(color, 1.0);
    o_history = vec4(color, 16.0 * gl_FragCoord.w);
}
