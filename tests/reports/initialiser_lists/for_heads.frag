#version 420 core
uniform float u_time;
uniform vec2 u_resolution;
out vec4 colour;

float wave(vec2 p) {
    return exp(sin(p.x * 3.1 + u_time)) * sin(p.y * 2.7);
}

float taken(inout vec2 p) {
    p += 0.5;
    return wave(p);
}

void main() {
    vec2 uv = gl_FragCoord.xy / u_resolution;
    vec2 sum = { 0.0, wave(uv) };
    for (ivec2 i = { 0, 3 }; i.x < i.y; i.x++) {
        vec2 part = { wave(uv + float(i.x)), 0.5 };
        sum += part;
    }
    for (int i = 0; i < 2; i++) {
        vec3 at = { wave(uv * float(i)), float(i), exp(sin(uv.x + float(i))) };
        sum += at.xz * 0.25;
    }
    vec2 unread = { taken(uv), 1.0 };
    vec2 chosen = { sum.x > 1.0 ? wave(uv.yx) : 0.5, wave(uv) };
    chosen += sum;
    if (uv.x > 0.5) {
        vec2 late = { wave(uv * 5.0), wave(uv * 6.0) };
        chosen *= late;
    }
    switch (int(uv.x * 4.0)) {
        case 1: vec2 here = { wave(uv * 8.0), 1.0 }; chosen += here; break;
        default: chosen += 0.25;
    }
    colour = vec4(chosen * exp(sin(sum)), uv);
}
