#version 330
// A dragon of polished marble: veins from five octaves of gradient noise, lit by a lamp, a dimmer one
// and the sky, after Blinn and Phong.

uniform sampler2D u_permutation;  // 64 x 64: a hash of each upright column of the noise lattice
uniform sampler2D u_gradients;    // 64 x 1: a gradient for each hash
uniform sampler2D u_detail;       // rgb: raggedness of the veins, alpha: polish

uniform vec3 u_eye;    // world space
uniform vec3 u_light;  // world space, towards the light, unit length

in vec3 v_position;  // object space
in vec3 v_normal;    // world space
in vec3 v_world;     // world space

const float CELL = 1.0 / 64.0;  // one lattice cell in the tables, which repeat after 64
const vec3 FILL = vec3(-0.80, 0.36, 0.48);  // world space, towards the dimmer lamp, unit length

layout(location = 0) out vec4 o_color;

// Perlin's quintic: its first and second derivatives vanish at 0 and 1.
vec3 fade(vec3 t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

// Three noises at once: three gradients, which are one gradient turned, along the same way.
vec3 slopes(vec3 gradient, vec3 way) {
    return way * mat3(gradient, gradient.yzx, gradient.zxy);
}

// Noise along one upright edge of a lattice cell: what its two corners give, blended.
// `at` is where the tables keep the lower corner, `way` leads from that corner to the point.
vec3 edge(vec3 at, vec3 way, float blend) {
    float hash = textureLod(u_permutation, at.xy, 0.0).r + at.z;
    vec3 lower = textureLod(u_gradients, vec2(hash, 0.5), 0.0).xyz;
    vec3 upper = textureLod(u_gradients, vec2(hash + CELL, 0.5), 0.0).xyz;
    return mix(slopes(lower, way), slopes(upper, way - vec3(0.0, 0.0, 1.0)), blend);
}

// Three independent gradient noises (Perlin 2002), each about -1 to 1. Their space is bent a little,
// or the lattice would show in the stone.
vec3 noise(vec3 p) {
    p += 0.1 * sin(3.0 * p.yzx);
    vec3 cell = floor(p);
    vec3 at = CELL * (cell + 0.5);
    vec3 way = p - cell;
    vec3 blend = fade(way);
    vec3 near = mix(
        edge(at, way, blend.z),
        edge(at + vec3(CELL, 0.0, 0.0), way - vec3(1.0, 0.0, 0.0), blend.z), blend.x);
    vec3 far = mix(
        edge(at + vec3(0.0, CELL, 0.0), way - vec3(0.0, 1.0, 0.0), blend.z),
        edge(at + vec3(CELL, CELL, 0.0), way - vec3(1.0, 1.0, 0.0), blend.z), blend.x);
    return mix(near, far, blend.y);
}

// Five octaves, each twice as fine and half as strong as the one before, in folded layers.
vec3 fbm(vec3 p) {
    p += 0.2 * sin(1.7 * p.zxy);
    return noise(p)
        + 0.5 * noise(p * 2.02)
        + 0.25 * noise(p * 4.05)
        + 0.125 * noise(p * 8.09)
        + 0.0625 * noise(p * 16.17);
}

// Albedo of the stone at a point of the block.
vec3 marble(vec3 p) {
    vec3 ragged = 0.08 * texture(u_detail, p.xy * 1.1 + 0.7 * p.z).rgb;
    vec3 turbulence = fbm(p * 2.3 + ragged);
    float strata = sin(dot(p, vec3(4.0, 6.6, 3.1)) + 3.1 * turbulence.x);
    float vein = exp2(-6.5 * strata * strata) * clamp(0.9 + 2.2 * turbulence.y, 0.0, 1.0);
    float rust = smoothstep(0.15, 0.5, turbulence.z * turbulence.x + 0.2 * strata);
    vec3 stone = mix(vec3(0.66, 0.60, 0.50), vec3(0.45, 0.45, 0.43), 0.5 + turbulence.z);
    stone = mix(stone, vec3(0.58, 0.38, 0.20), 0.5 * rust);
    return mix(stone, vec3(0.13, 0.17, 0.16), 0.9 * vein);
}

// Light from the sky and the lamps on the stone, and what its polish mirrors of them.
vec3 blinn_phong(vec3 albedo, vec3 normal, vec3 view, float polish) {
    float highlight = pow(max(dot(normal, normalize(u_light + view)), 0.0), 48.0);
    float glow = pow(max(dot(normal, normalize(FILL + view)), 0.0), 12.0);
    vec3 lamps = vec3(0.95, 0.90, 0.80) * max(dot(normal, u_light), 0.0)
        + vec3(0.12, 0.16, 0.22) * max(dot(normal, FILL), 0.0);
    float rim = 1.0 - max(dot(normal, view), 0.0);
    vec3 sky = mix(vec3(0.13, 0.11, 0.10), vec3(0.30, 0.34, 0.42), 0.5 + 0.5 * normal.y);
    return albedo * (sky + lamps)
        + polish * (highlight + 0.2 * glow + 3.0 * pow(rim, 5.0) * sky);
}

void main() {
    vec3 normal = normalize(v_normal);
    vec3 view = normalize(u_eye - v_world);
    float polish = 0.4 * texture(u_detail, v_position.zy * 1.3).a;
    vec3 light = blinn_phong(marble(v_position), normal, view, polish);
    o_color = vec4(sqrt(1.0 - exp2(-2.0 * light)), 1.0);  // exposed, for a display of gamma 2
}
