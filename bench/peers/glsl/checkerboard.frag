#version 330
// Half of the pixels are this frame's, the others are what the last picture shows of their points.

uniform sampler2D u_lower;    // the fields in even rows of the screen, each row in one of its own
uniform sampler2D u_upper;    // those in odd rows
uniform sampler2D u_history;  // the last picture; alpha: 16/w
uniform int u_turn;           // which fields are shaded: those where x + y + turn is even
uniform int u_begins;         // 1: there is no last picture

layout(location = 0) out vec4 o_color;
layout(location = 1) out vec4 o_history;

const float SAME = 0.01;  // of the nearness: what is so far off is another surface

// A shaded field, by its pixel on the screen; alpha 0 where nothing was drawn.
vec4 field(ivec2 pixel) {
    pixel = clamp(pixel, ivec2(0), ivec2(u_size) - 1);
    ivec2 cell = pixel >> 1;
    return (pixel.y & 1) == 0 ? texelFetch(u_lower, cell, 0) : texelFetch(u_upper, cell, 0);
}

vec3 filled(ivec2 pixel) {
    vec4 one[4] = vec4[](field(pixel - ivec2(1, 0)), field(pixel + ivec2(1, 0)),
        field(pixel - ivec2(0, 1)), field(pixel + ivec2(0, 1)));
    vec4 sum = vec4(0.0);
    vec3 least = vec3(1.0), most = vec3(0.0);
    for (int i = 0; i < 4; i++) {
        sum += vec4(one[i].rgb * one[i].a, one[i].a);
        least = min(least, one[i].a > 0.0 ? one[i].rgb : vec3(1.0));
        most = max(most, one[i].rgb);
    }
    vec2 place = last_place();
    vec4 last = textureLod(u_history, place / u_size, 0.0);
    float expected = 16.0 * last_nearness();
    bool found = u_begins == 0 && abs(last.a - expected) < SAME * expected
        && place == clamp(place, vec2(0.0), u_size);
    if (sum.a == 0.0) {
        return found ? last.rgb : vec3(0.0);
    }
    return found ? clamp(last.rgb, least, most) : sum.rgb / sum.a;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool fresh = ((pixel.x + pixel.y + u_turn) & 1) == 0;
    vec4 own = fresh ? field(pixel) : vec4(0.0);
    // At an outline the field and the pixel may disagree about what is covered.
    vec3 color = own.a > 0.0 ? own.rgb : filled(pixel);
    o_color = vec4(color, 1.0);
    o_history = vec4(color, 16.0 * gl_FragCoord.w);
}
