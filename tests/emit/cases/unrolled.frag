#version 330
uniform sampler2D u_map;
uniform vec3 u_tint;
uniform float u_time;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

//// The reference is the shader as it was.
//// unroll: yes
//// mode: plain
//// shows: original.frag
float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}
void main() {
    float a = 0.0;
    for (int i = 0; i < 3; i++)
        a += wave(v_uv.x + float(i));
    o_color = vec4(a);
}
//// becomes
#version 330
// shadercache: original, unchanged

uniform sampler2D u_map;
uniform vec3 u_tint;
uniform float u_time;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}

void main() {
    float a = 0.0;
    for (int i = 0; i < 3; i++)
        a += wave(v_uv.x + float(i));
    o_color = vec4(a);
}

//// In proof mode no sine of the reference is known beforehand.
//// unroll: yes
//// mode: proof
//// shows: original.frag
float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}
void main() {
    float a = 0.0;
    for (int i = 0; i < 3; i++)
        a += wave(v_uv.x + float(i));
    o_color = vec4(a);
}
//// becomes
#version 400
// shadercache: original, unchanged

invariant in vec2 v_uv;
layout(location = 0) precise out vec4 o_color;

float wave(float x) {
    precise float sc_exact_1 = sin(x - float(gl_FragCoord.x < 0.0)) * cos(x + 1.0 - float(gl_FragCoord.x < 0.0)) * sin(x * 2.0 - float(gl_FragCoord.x < 0.0));
    return sc_exact_1;
}

void main() {
    precise float a = float(gl_FragCoord.x < 0.0);
    for (precise int i = 0; i < 3; i++) {
        precise float sc_exact_1 = v_uv.x + float(i);
        a += wave(sc_exact_1);
    }
    o_color = vec4(a);
}

//// In proof mode no sine of a variant is known beforehand, in any trip.
//// unroll: yes
//// node: vec4(a)
//// mode: proof
//// shows: 2-pass.miss.frag wave main sc_shade
float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}
void main() {
    float a = 0.0;
    for (int i = 0; i < 3; i++)
        a += wave(v_uv.x + float(i));
    o_color = vec4(a);
}
//// becomes
float wave(float x) {
    precise float sc_exact_1 = sin(x - float(gl_FragCoord.x < 0.0)) * cos(x + 1.0 - float(gl_FragCoord.x < 0.0)) * sin(x * 2.0 - float(gl_FragCoord.x < 0.0));
    return sc_exact_1;
}
void sc_shade() {
    precise float a = float(gl_FragCoord.x < 0.0);
    {
        precise int i = 0;
        precise float sc_exact_1 = v_uv.x + float(i);
        a += wave(sc_exact_1);
    }
    {
        precise int i_1 = 1;
        precise float sc_exact_2 = v_uv.x + float(i_1);
        a += wave(sc_exact_2);
    }
    {
        precise int i_2 = 2;
        precise float sc_exact_3 = v_uv.x + float(i_2);
        a += wave(sc_exact_3);
    }
    sc_payload = vec4(a);
    o_color = sc_payload;
}
void main() {
    sc_shade();
    sc_store = sc_pack();
    sc_store_2 = sc_pack_2();
    sc_guard();
}

//// Of a partial sum the last trip is left.
//// unroll: yes
//// node: a += wave(v_uv.x + float(i))
//// path: [i=1]
//// shows: 3-pass.payload.frag
//// shows: 3-pass.shade.frag
float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}
void main() {
    float a = 0.0;
    for (int i = 0; i < 3; i++)
        a += wave(v_uv.x + float(i));
    o_color = vec4(a);
}
//// becomes
#version 330
// shadercache: 3-pass.payload, node main.9u-420fc357

const float sc_poison_depth = -65504.0; // depth of what must not be reused
uniform float sc_limit; // the largest value that is reused
uniform float sc_least; // the smallest one above zero that it surely holds
in vec4 sc_current; // clip-space position in this frame
layout(location = 0) out vec4 sc_store; // what the next frame finds in the cache
float sc_payload;
in vec2 v_uv;

float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}

void sc_compute() {
    float a = 0.0;
    {
        int i = 0;
        a += wave(v_uv.x + float(i));
    }
    {
        int i_1 = 1;
        sc_payload = a + wave(v_uv.x + float(i_1));
    }
}

// What is stored of the payloads.
vec4 sc_pack() {
    return vec4(sc_payload, 0.0, 0.0, 16.0 / sc_current.w);
}

// Can the cache not hold a value? The bits are compared: they are in the order of the sizes, NaN lies
// above infinity, and no driver can make less of them than they are.
bool sc_unfit(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    uint least = max(floatBitsToUint(sc_least), 1u) - 1u;
    return any(greaterThan(sizes, uvec4(floatBitsToUint(sc_limit)))) || any(lessThan(sizes - 1u, uvec4(least)));
}

// Numbers as near as half floats can hold them. Infinity and NaN stay.
vec4 sc_held(vec4 values) {
    uvec4 sizes = floatBitsToUint(values) & 0x7FFFFFFFu;
    vec4 held = mix(clamp(values, vec4(-sc_limit), vec4(sc_limit)), values, greaterThanEqual(sizes, uvec4(0x7F800000u)));
    return mix(values, held, greaterThan(sizes, uvec4(floatBitsToUint(sc_limit))));
}

// A cache of half floats is written what it can hold.
void sc_hold() {
    if (sc_limit <= 65504.0) {
        sc_store = sc_held(sc_store);
    }
}

// Marks a texel that must not be reused. The third of three passes reads it in this frame, so it
// holds what was computed, or what comes nearest of larger numbers.
void sc_guard() {
    bool unfit = sc_unfit(sc_store);
    if (unfit) {
        sc_hold();
        sc_store.w = sc_poison_depth;
    }
}

// Three passes, second: the payload alone, for the pixels that the first pass left open.
void main() {
    sc_compute();
    sc_store = sc_pack();
    sc_guard();
}

#version 330
// shadercache: 3-pass.shade, node main.9u-420fc357

uniform sampler2D sc_payloads; // what this frame has stored so far
float sc_payload;
in vec2 v_uv;
layout(location = 0) out vec4 o_color;

float wave(float x) {
    return sin(x) * cos(x + 1.0) * sin(x * 2.0);
}

void sc_shade() {
    float a;
    {
        a = sc_payload;
    }
    {
        int i_2 = 2;
        a += wave(v_uv.x + float(i_2));
    }
    o_color = vec4(a);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    sc_payload = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0).x;
    sc_shade();
}
