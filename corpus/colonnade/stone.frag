#version 330
// Weathered marble: veins, stains that run down, pits, and lichen on what faces the sky.

uniform vec3 u_eye;    // world space
uniform vec3 u_light;  // world space, towards the sun, unit length

in vec3 v_world;   // world space
in vec3 v_normal;  // world space

layout(location = 0) out vec4 o_color;

// Numbers from 0 to 1 for four cells of the lattice.
vec4 hash(uvec4 x) {
    x = (x ^ (x >> 15u)) * 2246822519u;
    return vec4((x ^ (x >> 13u)) >> 8u) * (1.0 / 16777216.0);
}

// Value noise, 0 to 1, with Perlin's fade.
float noise(vec3 p) {
    vec3 low = floor(p);
    vec3 t = p - low;
    t = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    uvec3 here = uvec3(ivec3(low)) * uvec3(1597334673u, 3812015801u, 2798796415u);
    uvec3 next = here + uvec3(1597334673u, 3812015801u, 2798796415u);
    uvec4 cells = uvec4(here.x, next.x, here.x, next.x) ^ uvec4(here.yy, next.yy);
    vec4 edge = mix(hash(cells ^ here.z), hash(cells ^ next.z), t.z);
    vec2 side = mix(edge.xy, edge.zw, t.y);
    return mix(side.x, side.y, t.x);
}

// Five octaves, 0 to 1.
float clouds(vec3 p) {
    return (noise(p) + 0.5 * noise(2.03 * p + 7.1) + 0.25 * noise(4.01 * p + 3.7)
        + 0.125 * noise(8.05 * p + 1.3) + 0.0625 * noise(16.1 * p + 9.2)) / 1.9375;
}

// Colour of the stone at a point.
vec3 marble(vec3 p) {
    vec3 bent = p + 0.5 * vec3(clouds(0.9 * p), clouds(0.9 * p + 19.0), clouds(0.9 * p + 43.0));
    float strata = sin(2.6 * bent.y + 3.4 * bent.x + 2.1 * bent.z + 5.0 * clouds(1.6 * bent));
    float vein = exp2(-26.0 * strata * strata) * smoothstep(0.35, 0.65, clouds(1.3 * p + 5.0));
    float stain = smoothstep(0.45, 0.75, clouds(vec3(2.6 * p.x, 0.22 * p.y, 2.6 * p.z)));
    float pits = smoothstep(0.62, 0.78, clouds(21.0 * p + 3.0));
    vec3 stone = mix(vec3(0.74, 0.68, 0.57), vec3(0.88, 0.84, 0.76), clouds(2.2 * p + 31.0));
    stone = mix(stone, vec3(0.50, 0.42, 0.34), 0.55 * vein);
    stone = mix(stone, vec3(0.42, 0.37, 0.30), 0.50 * stain);
    return stone * (1.0 - 0.22 * pits);
}

void main() {
    vec3 normal = normalize(v_normal);
    vec3 view = normalize(u_eye - v_world);
    vec3 albedo = marble(v_world);
    float facing = max(dot(normal, u_light), 0.0);
    // Under the beams little of the sky is seen, and no sun where they are between.
    float inside = 1.0 - smoothstep(6.2, 8.4, abs(v_world.x) + 0.35 * max(abs(v_world.z) - 14.0, 0.0));
    float shade = inside * smoothstep(0.5, 5.6, v_world.y + 2.0 * (1.0 - abs(normal.y)));
    vec3 sun = vec3(1.40, 1.20, 0.92) * facing * (1.0 - 0.7 * shade);
    vec3 sky = mix(vec3(0.26, 0.22, 0.17), vec3(0.36, 0.45, 0.62), 0.5 + 0.5 * normal.y);
    float shine = 0.10 * pow(max(dot(normal, normalize(u_light + view)), 0.0), 20.0) * facing;
    vec3 light = albedo * (sun + sky * (1.0 - 0.45 * shade)) + shine;
    float haze = 1.0 - exp2(-0.012 * length(u_eye - v_world));
    light = mix(light, vec3(0.60, 0.62, 0.62), haze);
    o_color = vec4(sqrt(1.0 - exp2(-1.5 * light)), 1.0);
}
