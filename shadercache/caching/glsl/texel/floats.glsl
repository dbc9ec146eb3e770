// Texels of floats, for payloads that are made of floats alone.

vec4 sc_FLOATS(vec4 texel) {
    return texel;
}

vec4 sc_OF_FLOATS(vec4 floats) {
    return floats;
}

vec4 sc_MERGED(vec4 floats, vec4 texel, uvec4 discrete) {
    return floats;
}

vec4 sc_ONLY_FLOATS(vec4 texel, uvec4 discrete) {
    return texel;
}

vec4 sc_BLENDED(vec4 a, vec4 b, vec4 c, vec4 d, vec2 part, uvec4 discrete) {
    return mix(mix(a, b, part.x), mix(c, d, part.x), part.y);
}

float sc_MARKED(float depth) {
    return sc_moved ? -depth : depth;
}

vec4 sc_IN_RANGE(vec4 texel, uvec4 discrete) {
    return sc_near(texel);
}

void sc_HOLD() {
    sc_hold();
}

void sc_AGREE() {
}

vec4 sc_MISSED() {
    return vec4(float(sc_group), 0.0, 0.0, sc_missed_depth);
}

// Numbers as near as half floats can hold them. Infinity and NaN stay.
vec4 sc_held(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    vec4 held = mix(clamp(values, vec4(-sc_limit), vec4(sc_limit)), values, greaterThanEqual(sizes, uvec4(0x7F800000u)));
    return mix(values, held, greaterThan(sizes, uvec4(floatBitsToUint(sc_limit))));
}

// A cache of half floats is written what it can hold.
void sc_hold() {
    if (sc_limit <= sc_MOST_OF_HALF) {
        sc_store = sc_held(sc_store);
    }
}
