#version 450 core
uniform float u_time;
uniform vec2 u_resolution;
struct Ray {
    vec2 from;
    float reach[2];
};
struct Light {
    Ray ray;
    float power;
};
out vec4 colour;

float wave(vec2 p) {
    return exp(sin(p.x * 3.1 + u_time)) * sin(p.y * 2.7);
}

Ray ray_of(vec2 p) {
    Ray Ray = { p, { wave(p), 1 } };
    return Ray;
}

float inner(vec2 p) {
    struct Light { vec2 at; };
    Light light = { { wave(p), 0.5 } };
    return light.at.x;
}

void main() {
    vec2 uv = gl_FragCoord.xy / u_resolution;
    Light light = { { { wave(uv), uv.x }, { 1, wave(uv.yx) } }, 2 };
    Light two[2] = { { ray_of(uv), wave(uv * 3.0) }, light };
    struct { float level; vec2 at; } plain = { wave(uv * 5.0), { wave(uv * 7.0), 1.0 } };
    struct { vec2 at; } many[2] = { { uv }, { { wave(uv * 9.0), inner(uv) } } };
    vec2 sum = light.ray.from + two[0].ray.from + plain.at * plain.level + many[1].at;
    colour = vec4(exp(sin(sum)) * two[1].power, two[0].power, light.ray.reach[1]);
}
