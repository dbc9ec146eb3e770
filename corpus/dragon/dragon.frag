#version 330
// A dragon of polished marble: veins from five octaves of gradient noise, lit after Blinn and Phong.

uniform sampler2D u_permutation;  // 64 x 64: hashes of the four lower corners of a lattice cell
uniform sampler2D u_gradients;    // 64 x 1: a gradient for each hash
uniform sampler2D u_detail;       // red: crystal grain, green: polish

uniform vec3 u_eye;    // world space
uniform vec3 u_light;  // world space, towards the light, unit length

in vec3 v_position;  // object space
in vec3 v_normal;    // world space
in vec3 v_world;     // world space

layout(location = 0) out vec4 o_color;

// Perlin's quintic: its first and second derivatives vanish at 0 and 1.
vec3 fade(vec3 t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

// The gradient at one corner of a cell, along the way from that corner to the point.
float corner(float hash, vec3 way) {
    return dot(textureLod(u_gradients, vec2(hash, 0.5), 0.0).xyz, way);
}

// Gradient noise (Perlin 2002), about -1 to 1, with a period of 64 cells.
float noise(vec3 p) {
    vec3 cell = floor(p);
    vec3 way = p - cell;
    vec3 blend = fade(way);
    vec4 low = textureLod(u_permutation, (cell.xy + 0.5) / 64.0, 0.0) + cell.z / 64.0;
    vec4 high = low + 1.0 / 64.0;
    return mix(
        mix(mix(corner(low.x, way), corner(low.y, way - vec3(1.0, 0.0, 0.0)), blend.x),
            mix(corner(low.z, way - vec3(0.0, 1.0, 0.0)), corner(low.w, way - vec3(1.0, 1.0, 0.0)), blend.x),
            blend.y),
        mix(mix(corner(high.x, way - vec3(0.0, 0.0, 1.0)), corner(high.y, way - vec3(1.0, 0.0, 1.0)), blend.x),
            mix(corner(high.z, way - vec3(0.0, 1.0, 1.0)), corner(high.w, way - vec3(1.0, 1.0, 1.0)), blend.x),
            blend.y),
        blend.z);
}

// Five octaves, each twice as fine and half as strong as the one before.
float fbm(vec3 p) {
    return noise(p)
        + 0.5 * noise(p * 2.02)
        + 0.25 * noise(p * 4.05)
        + 0.125 * noise(p * 8.09)
        + 0.0625 * noise(p * 16.17);
}

// Albedo of the stone at a point of the block.
vec3 marble(vec3 p) {
    float turbulence = fbm(p * 2.3 + vec3(3.7, 1.9, 5.3));
    float strata = sin(dot(p, vec3(3.1, 5.2, 2.3)) + 3.4 * turbulence);
    float vein = exp2(-9.0 * strata * strata);
    float cloud = 0.5 + 0.5 * sin(2.6 * turbulence + p.y * 2.0);
    float grain = texture(u_detail, p.xy * 1.7 + p.z).r;
    vec3 stone = mix(vec3(0.80, 0.76, 0.68), vec3(0.62, 0.60, 0.55), cloud);
    return mix(stone, vec3(0.16, 0.20, 0.19), 0.85 * vein) * (0.85 + 0.30 * grain);
}

// Diffuse light from the sky and the lamp, and a highlight on the polished stone.
vec3 blinn_phong(vec3 albedo, vec3 normal, vec3 view, float polish) {
    vec3 halfway = normalize(u_light + view);
    float lambert = max(dot(normal, u_light), 0.0);
    float highlight = pow(max(dot(normal, halfway), 0.0), 20.0 + 60.0 * polish);
    vec3 sky = mix(vec3(0.13, 0.11, 0.10), vec3(0.30, 0.34, 0.42), 0.5 + 0.5 * normal.y);
    return albedo * (sky + vec3(0.95, 0.90, 0.80) * lambert) + 0.35 * polish * highlight;
}

void main() {
    vec3 normal = normalize(v_normal);
    vec3 view = normalize(u_eye - v_world);
    float polish = texture(u_detail, v_position.zy * 1.3).g;
    vec3 albedo = marble(v_position);
    vec3 light = blinn_phong(albedo, normal, view, polish);
    o_color = vec4(pow(min(light, 1.0), vec3(1.0 / 2.2)), 1.0);
}
