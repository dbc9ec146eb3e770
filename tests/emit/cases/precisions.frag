//// A sum is as precise as its operands, one of which is highp.
//// node: low += sin(v_position.x) * cos(v_position.y) * exp(v_position.z) * sin(v_position.y)
//// shows: 3-pass.shade.frag
#version 300 es

precision mediump float;
in highp vec3 v_position;
out vec4 o_color;

void main() {
    float low = 0.5;
    low += sin(v_position.x) * cos(v_position.y) * exp(v_position.z) * sin(v_position.y);
    low *= sin(low) * cos(low) * sin(low * 2.0) * sin(low * 3.0);
    o_color = vec4(low);
}
//// vertex
#version 300 es

in vec3 a_position;
uniform mat4 u_mvp;
out highp vec3 v_position;

void main() {
    v_position = a_position;
    gl_Position = u_mvp * vec4(a_position, 1.0);
}
//// becomes
#version 300 es
// shadercache: 3-pass.shade, node main.1-8db045ee

precision mediump float;
uniform highp sampler2D sc_payloads; // what this frame has stored so far
highp float sc_payload;
layout(location = 0) out vec4 o_color;

void sc_shade() {
    float low;
    low = sc_payload;
    low *= sin(low) * cos(low) * sin(low * 2.0) * sin(low * 3.0);
    o_color = vec4(low);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    sc_payload = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0).x;
    sc_shade();
}

//// A product is as precise as its operands, all of which are mediump.
//// node: low *= sin(low) * cos(low) * sin(low * 2.0) * sin(low * 3.0)
//// shows: 3-pass.shade.frag
#version 300 es

precision mediump float;
in highp vec3 v_position;
out vec4 o_color;

void main() {
    float low = 0.5;
    low += sin(v_position.x) * cos(v_position.y) * exp(v_position.z) * sin(v_position.y);
    low *= sin(low) * cos(low) * sin(low * 2.0) * sin(low * 3.0);
    o_color = vec4(low);
}
//// vertex
#version 300 es

in vec3 a_position;
uniform mat4 u_mvp;
out highp vec3 v_position;

void main() {
    v_position = a_position;
    gl_Position = u_mvp * vec4(a_position, 1.0);
}
//// becomes
#version 300 es
// shadercache: 3-pass.shade, node main.18-2fd19f0a

precision mediump float;
uniform highp sampler2D sc_payloads; // what this frame has stored so far
mediump float sc_payload;
layout(location = 0) out vec4 o_color;

void sc_shade() {
    float low;
    low = sc_payload;
    o_color = vec4(low);
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    sc_payload = texelFetch(sc_payloads, ivec2(gl_FragCoord.xy), 0).x;
    sc_shade();
}

//// Counters of unrolled loops keep their precision.
//// unroll: yes
//// node: vec4(a)
//// shows: 2-pass.miss.frag sc_shade main
#version 300 es

precision mediump float;
in highp vec3 v_position;
out vec4 o_color;

void main() {
    highp float a = 0.0;
    for (float t = 0.5; t < 2.0; t += 1.0)
        a += sin(v_position.x * t) * cos(a) * exp(a);
    for (lowp int i = 0; i < 2; i++)
        a *= sin(v_position.y + float(i)) * cos(a) * exp(a);
    o_color = vec4(a);
}
//// vertex
#version 300 es

in vec3 a;
out highp vec3 v_position;

void main() {
    v_position = a;
    gl_Position = vec4(a, 1.0);
}
//// becomes
void sc_shade() {
    highp float a = 0.0;
    {
        float t = 0.5;
        a += sin(v_position.x * t) * cos(a) * exp(a);
    }
    {
        float t_1 = 1.5;
        a += sin(v_position.x * t_1) * cos(a) * exp(a);
    }
    {
        lowp int i = 0;
        a *= sin(v_position.y + float(i)) * cos(a) * exp(a);
    }
    {
        lowp int i_1 = 1;
        a *= sin(v_position.y + float(i_1)) * cos(a) * exp(a);
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
