#version 330
// shadercache: 2-pass.hit, node stone.27-f6bd6cd8

uniform int sc_clock;
uniform int sc_period;
uniform int sc_block;
uniform sampler2D sc_cache;
in vec4 sc_current;
in vec4 sc_previous;
uniform float sc_epsilon;
vec3 sc_payload;
bool sc_moved = false;
layout(location = 1) out vec4 sc_store;
bool sc_lacks = false;
uniform sampler2D u_map;
uniform vec3 u_tint;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
layout(location = 0) out vec4 o_color;

float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7);
}

vec3 sc_stone(vec3 p) {
    float octaves = noise(p) + 0.5 * noise(p * 2.0) + 0.25 * noise(p * 4.0);
    return mix(vec3(0.2), vec3(0.9), octaves) * sc_payload;
}

void sc_shade() {
    vec3 normal = normalize(v_normal);
    vec3 albedo = sc_stone(v_position);
    float light = max(dot(normal, u_tint), 0.0);
    o_color = vec4(albedo * light + texture(u_map, v_uv).rgb, 1.0);
}

uint sc_hash(uint x) {
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    x *= 0x9E3779B9u;
    return x ^ x >> 15;
}

int sc_residue(uint hashed) {
    return int((hashed >> 16) * uint(sc_period) >> 16);
}

int sc_swap(int slot, int partner, uint key) {
    int other = partner - slot;
    other += other < 0 ? sc_period : 0;
    return ((key + uint(max(slot, other))) * 0x9E3779B9u & 0x80000000u) == 0u ? slot : other;
}

int sc_turn() {
    float shrink = 1.0 / float(sc_block);
    vec2 block = floor(gl_FragCoord.xy * shrink);
    float across = ceil((float(textureSize(sc_cache, 0).x) - 0.5) * shrink);
    float number = block.y * across + block.x;
    float group = floor((number + 0.5) / float(sc_period));
    uint key = sc_hash(uint(group) * 9277u + 26699u);
    int turn = int(number - group * float(sc_period)) + sc_residue(key * 0xC2B2AE35u);
    turn -= turn >= sc_period ? sc_period : 0;
    turn = sc_swap(turn, sc_residue(key), key);
    return sc_swap(turn, sc_residue(key << 16), key ^ 0x85EBCA6Bu);
}

bool sc_due() {
    int phase = sc_turn() + sc_clock;
    return phase == 0 || phase == sc_period;
}

vec4 sc_chosen(vec4 a, vec4 b, vec4 c, vec4 d, vec4 weights) {
    vec4 sum = weights.x > 0.0 ? weights.x * a : vec4(0.0);
    sum += weights.y > 0.0 ? weights.y * b : vec4(0.0);
    sum += weights.z > 0.0 ? weights.z * c : vec4(0.0);
    return sum + (weights.w > 0.0 ? weights.w * d : vec4(0.0));
}

int sc_look_up(out vec4 texel) {
    ivec2 last = textureSize(sc_cache, 0) - 1;
    vec2 motion = sc_previous.xy / sc_previous.w - sc_current.xy / sc_current.w;
    vec2 corner = gl_FragCoord.xy - 0.5 + 0.5 * vec2(last + 1) * motion;
    vec2 slope = vec2(dFdx(16.0 / sc_previous.w), dFdy(16.0 / sc_previous.w)) / (16.0 / sc_previous.w);
    vec2 whole = floor(corner);
    vec2 part = corner - whole;
    ivec2 near = clamp(ivec2(whole), ivec2(0), last);
    ivec2 far = min(near + ivec2(ceil(part)), last);
    vec4 a = texelFetch(sc_cache, near, 0);
    vec4 b = texelFetch(sc_cache, ivec2(far.x, near.y), 0);
    vec4 c = texelFetch(sc_cache, ivec2(near.x, far.y), 0);
    vec4 d = texelFetch(sc_cache, far, 0);
    texel = mix(mix(a, b, part.x), mix(c, d, part.x), part.y);
    if (sc_due()) {
        return 2;
    }
    if (!(sc_previous.w > 0.0 && all(greaterThanEqual(corner, vec2(0.0))) && all(lessThanEqual(corner, vec2(last))))) {
        return 3;
    }
    vec4 aside = 0.0625 * sc_previous.w * abs(vec4(a.w, b.w, c.w, d.w)) - 1.0 - slope.x * vec4(-part.x, 1.0 - part.x, -part.x, 1.0 - part.x) - slope.y * vec4(-part.y, -part.y, 1.0 - part.y, 1.0 - part.y);
    bvec4 moved = lessThan(vec4(a.w, b.w, c.w, d.w), vec4(0.0));
    vec4 single = vec4(lessThanEqual(abs(aside), vec4(sc_epsilon))) * vec4(not(moved));
    vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.y, 1.0 - part.y, part.y, part.y);
    float blended = dot(weights, abs(vec4(a.w, b.w, c.w, d.w)));
    bool one_surface = all(lessThanEqual(abs(0.0625 * sc_previous.w * abs(vec4(a.w, b.w, c.w, d.w)) - 1.0), vec4(24.0 * sc_epsilon)));
    bool agrees = one_surface && abs(0.0625 * sc_previous.w * blended - 1.0) <= sc_epsilon;
    if (one_surface && !agrees) {
        return 4;
    }
    bool marked = dot(weights, vec4(moved)) > 0.0;
    if (!agrees) {
        weights *= single;
        float total = dot(weights, vec4(1.0));
        if (!(total >= 0.25)) {
            return a.w == -65504.0 || b.w == -65504.0 || c.w == -65504.0 || d.w == -65504.0 ? 6 : 4;
        }
        weights /= total;
        texel = sc_chosen(a, b, c, d, weights);
        marked = true;
    }
    sc_moved = marked;
    return 1;
}

vec4 sc_texel() {
    return vec4(sc_payload, sc_moved ? -(16.0 / sc_current.w) : 16.0 / sc_current.w);
}

void main() {
    vec4 texel;
    sc_lacks = sc_look_up(texel) != 1;
    sc_payload = texel.xyz;
    sc_shade();
    sc_store = sc_texel();
    if (sc_lacks) {
        discard;
    }
}
