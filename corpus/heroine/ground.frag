#version 330
// Flagstones with moss in the joints, and a soft shadow where she stands.

uniform vec3 u_eye;     // world space
uniform vec3 u_light;   // world space, towards the sun, unit length
uniform vec3 u_walker;  // world space: where she stands

in vec3 v_world;  // world space

layout(location = 0) out vec4 o_color;

// Numbers from 0 to 1 for four cells of the lattice.
vec4 hash(uvec4 x) {
    x = (x ^ (x >> 15u)) * 2246822519u;
    return vec4((x ^ (x >> 13u)) >> 8u) * (1.0 / 16777216.0);
}

// The number of a stone, 0 to 1.
float one_of(ivec2 cell) {
    uvec2 x = uvec2(cell) * uvec2(1597334673u, 3812015801u);
    return hash(uvec4(x.x ^ x.y)).x;
}

// Value noise, 0 to 1, with Perlin's fade.
float noise(vec2 p) {
    vec2 low = floor(p);
    vec2 t = p - low;
    t = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    uvec2 here = uvec2(ivec2(low)) * uvec2(1597334673u, 3812015801u);
    uvec2 next = here + uvec2(1597334673u, 3812015801u);
    vec4 edge = hash(uvec4(here.x, next.x, here.x, next.x) ^ uvec4(here.yy, next.yy));
    vec2 side = mix(edge.xy, edge.zw, t.y);
    return mix(side.x, side.y, t.x);
}

float clouds(vec2 p) {
    return (noise(p) + 0.5 * noise(2.03 * p + 7.1) + 0.25 * noise(4.01 * p + 3.7)
        + 0.125 * noise(8.05 * p + 1.3) + 0.0625 * noise(16.1 * p + 9.2)) / 1.9375;
}

// Flagstones: rows of stones of two to a row's width, each of its own grey.
vec3 paving(vec2 p) {
    p += 0.02 * (vec2(clouds(5.0 * p), clouds(5.0 * p + 31.0)) - 0.5);
    float row = floor(p.y / 0.55);
    vec2 stone = vec2(p.x / 0.8 + 0.37 * row, p.y / 0.55);
    ivec2 cell = ivec2(floor(stone));
    vec2 edge = (0.5 - abs(fract(stone) - 0.5)) * vec2(0.8, 0.55);
    float joint = 1.0 - smoothstep(0.008, 0.022, min(edge.x, edge.y));
    float grain = clouds(9.0 * p + 17.0 * one_of(cell));
    vec3 grey = mix(vec3(0.30, 0.28, 0.26), vec3(0.62, 0.58, 0.51), 0.35 * one_of(cell) + 0.65 * grain);
    grey *= 0.86 + 0.14 * noise(140.0 * p);
    vec3 moss = mix(vec3(0.10, 0.13, 0.05), vec3(0.26, 0.30, 0.12), clouds(23.0 * p));
    return mix(grey, moss, clamp(joint + smoothstep(0.60, 0.72, clouds(1.7 * p)) * 0.5, 0.0, 1.0));
}

void main() {
    vec3 albedo = paving(v_world.xz);
    vec2 from = v_world.xz - u_walker.xz;
    vec2 way = -normalize(u_light.xz);
    float along = dot(from, way), across = dot(from, vec2(-way.y, way.x));
    float fallen = smoothstep(-0.15, 0.1, along) * (1.0 - smoothstep(1.3, 1.9, along));
    float shadow = fallen * (1.0 - smoothstep(0.08, 0.30, abs(across)));
    shadow = max(shadow, 0.8 * (1.0 - smoothstep(0.05, 0.40, length(from))));
    float far = smoothstep(4.0, 9.0, length(v_world.xz - u_eye.xz));
    vec3 light = albedo * (vec3(1.25, 1.08, 0.86) * 0.62 * (1.0 - 0.75 * shadow) + vec3(0.30, 0.34, 0.40));
    vec3 color = mix(light, vec3(0.62, 0.60, 0.58), far);
    o_color = vec4(sqrt(1.0 - exp2(-1.7 * color)), 1.0);
}
