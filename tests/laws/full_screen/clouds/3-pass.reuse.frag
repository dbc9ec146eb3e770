#version 330
// shadercache: 3-pass.reuse, node mainImage.23-b73a27b8

// A Shadertoy of our own: clouds that stand still above a sea that moves. Of the clouds nothing
// depends on iTime, so the value of the same pixel stays right for ever.

uniform int sc_clock;
uniform int sc_period;
uniform int sc_block;
uniform sampler2D sc_cache;
uniform float sc_epsilon;
float sc_payload;
bool sc_moved = false;
layout(location = 0) out vec4 sc_store;

uint sc_hash(uvec2 block) {
    uint x = block.x * 1973u + block.y * 9277u + 26699u;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    x *= 0x9E3779B9u;
    return x ^ x >> 15;
}

bool sc_due() {
    uvec2 block = uvec2(gl_FragCoord.xy / float(sc_block));
    int h = int((sc_hash(block) >> 16) * uint(sc_period) >> 16);
    int phase = h + sc_clock;
    return phase == 0 || phase == sc_period;
}

int sc_look_up(out vec4 texel) {
    ivec2 own = ivec2(gl_FragCoord.xy);
    texel = texelFetch(sc_cache, own, 0);
    if (sc_due()) {
        return 2;
    }
    if (!(abs(texel.w - 16.0 * gl_FragCoord.w) <= sc_epsilon * (16.0 * gl_FragCoord.w))) {
        return texel.w == 32768.0 ? 6 : 4;
    }
    return 1;
}

vec4 sc_texel() {
    return vec4(sc_payload, 0.0, 0.0, sc_moved ? -(16.0 * gl_FragCoord.w) : 16.0 * gl_FragCoord.w);
}

void main() {
    vec4 texel;
    if (sc_look_up(texel) != 1) {
        discard;
    }
    sc_payload = texel.x;
    sc_store = sc_texel();
}
