// Payloads for a fraction of the pixels, in a cache that is as much smaller. Each pixel takes its own
// from those texels of this frame around it that show its surface. What it takes is never stored.

ivec2 sc_OWN_TEXEL() {
    return ivec2(gl_FragCoord.xy);
}

// What the texels around the pixel that show its surface say of its payload; are there any?
bool sc_neighbours(out sc_TEXELS sc_texel) {
    sc_HERE();
    // Ahead of every exit, as derivatives must be: how the depth changes from texel to texel.
    float own = sc_SEEN_DEPTH();
    vec2 slope = vec2(dFdx(own), dFdy(own)) / sc_scale.xy;
    // Counted in texels from the middle of the first one, of which there are none beyond the edges.
    vec2 place = gl_FragCoord.xy * sc_scale.xy + sc_scale.zw - 0.5;
    vec2 last = vec2(textureSize(sc_payloads, 0) - 1);
    vec2 inside = clamp(place, vec2(0.0), last);
    ivec2 near = ivec2(inside);
    ivec2 far = min(near + 1, ivec2(last));
    sc_TEXELS a = sc_READ(sc_payloads, near, sc_discrete);
    sc_TEXELS b = sc_READ(sc_payloads, ivec2(far.x, near.y), sc_discrete);
    sc_TEXELS c = sc_READ(sc_payloads, ivec2(near.x, far.y), sc_discrete);
    sc_TEXELS d = sc_READ(sc_payloads, far, sc_discrete);
    vec2 part = inside - vec2(near);
    vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.y, 1.0 - part.y, part.y, part.y);
    // Which show the surface, where it slopes on as it does at the pixel?
    vec4 expected = own + slope.x * (vec4(near.x, far.x, near.x, far.x) - place.x)
        + slope.y * (vec4(near.y, near.y, far.y, far.y) - place.y);
    vec4 depths = abs(vec4(sc_FLOATS(a.w), sc_FLOATS(b.w), sc_FLOATS(c.w), sc_FLOATS(d.w)));
    weights *= vec4(lessThanEqual(abs(depths - expected), vec4(sc_NEARBY * sc_SEEN_UNIT())));
    // Where it is seen edge on, its slope leads to whatever lies behind it.
    weights *= vec4(lessThanEqual(abs(depths - own), vec4(sc_STEEPEST * sc_SEEN_UNIT())));
    sc_FIT_OBJECT(weights);
    float total = dot(weights, vec4(1.0));
    sc_AMONG(weights, total);
    sc_texel = sc_MERGED(sc_OF_FLOATS(sc_chosen(sc_FLOATS(a), sc_FLOATS(b), sc_FLOATS(c), sc_FLOATS(d), weights)), a, sc_discrete);
    sc_AGREE();
    return total >= sc_LEAST_WEIGHT;
}
