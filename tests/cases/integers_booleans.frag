#version 330
// Integer, unsigned and boolean values, which must never be filtered.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


uint hash(uvec2 p) {
    uint x = p.x * 1664525u + p.y * 22695477u;
    x ^= x >> 15u;
    x = (x << 3u) + ~x;
    return x * 2654435761u;
}

void main() {
    ivec2 cell = ivec2(floor(v_uv * 12.0));
    uint bits = hash(uvec2(cell + 100));
    float noise = float(bits >> 8u) / 16777216.0;
    bool lit = wave(v_position) > 0.1 && dot(v_normal, u_light) > 0.0;
    bvec3 above = greaterThan(v_normal, vec3(0.2));
    int stripes = cell.x % 3 - (cell.y & 1);
    uvec3 triple = uvec3(bits & 255u, bits % 7u, uint(stripes + 3));
    float wood = wave(v_normal) * (lit ? noise : float(stripes) * 0.25);
    vec3 mixed = mix(vec3(noise), vec3(triple) / 255.0, above);
    o_color = vec4(mixed * wood, any(above) ? 1.0 : 0.5);
}
