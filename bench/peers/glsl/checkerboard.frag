#version 330
#extension GL_ARB_texture_gather : require
// Half of the pixels are this frame's, the others are what the last picture shows of their points.

uniform sampler2D u_lower;    // the fields in even rows of the screen, each row in one of its own
uniform sampler2D u_upper;    // those in odd rows; alpha 0 where nothing was drawn
uniform int u_turn;           // which fields are shaded: those where x + y + turn is even

layout(location = 0) out vec4 o_color;
layout(location = 1) out vec4 o_history;

// The shaded field upon a pixel of the screen.
vec4 field(sampler2D fields, ivec2 pixel) {
    return texelFetch(fields, clamp(pixel, ivec2(0), ivec2(u_size) - 1) >> 1, 0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool fresh = ((pixel.x + pixel.y + u_turn) & 1) == 0;
    bool even = (pixel.y & 1) == 0;
    // Beside a missing pixel are two fields of its own row, above and below two of the other rows.
    ivec2 beside = ivec2(fresh ? 0 : 1, 0), above = ivec2(0, 1);
    ivec2 in_lower = even ? beside : above, in_upper = even ? above : beside;
    vec4 a = field(u_lower, pixel - in_lower), b = field(u_lower, pixel + in_lower);
    vec4 c = field(u_upper, pixel - in_upper), d = field(u_upper, pixel + in_upper);
    vec4 own = even ? a : c;

    vec4 sum = vec4(a.rgb * a.a, a.a) + vec4(b.rgb * b.a, b.a)
        + vec4(c.rgb * c.a, c.a) + vec4(d.rgb * d.a, d.a);
    vec4 none = step(vec4(a.a, b.a, c.a, d.a), vec4(0.0));
    vec3 least = min(min(a.rgb + none.x, b.rgb + none.y), min(c.rgb + none.z, d.rgb + none.w));
    vec3 most = max(max(a.rgb, b.rgb), max(c.rgb, d.rgb));

    vec4 last = what_was_shown();
    vec3 filled = sum.a == 0.0 ? last.rgb
        : last.a > 0.0 ? clamp(last.rgb, least, most) : sum.rgb / max(sum.a, 1.0);

    // At an outline the field and the pixel may disagree about what is covered.
    vec3 color = fresh && own.a > 0.0 ? own.rgb : filled;
    o_color = vec4(color, 1.0);
    o_history = vec4(16.0 * gl_FragCoord.w, color);
}
