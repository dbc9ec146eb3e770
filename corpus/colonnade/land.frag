#version 330
// Dry grass and bare ground.

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

// Colour of the land at a point.
vec3 grass(vec3 p) {
    float patches = clouds(0.35 * p);
    float tufts = clouds(4.5 * p + 11.0);
    vec3 dry = mix(vec3(0.34, 0.30, 0.13), vec3(0.56, 0.50, 0.26), tufts);
    vec3 bare = mix(vec3(0.40, 0.32, 0.22), vec3(0.58, 0.49, 0.37), clouds(1.7 * p + 7.0));
    return mix(dry, bare, smoothstep(0.48, 0.62, patches));
}

void main() {
    vec3 albedo = grass(v_world);
    float facing = max(dot(normalize(v_normal), u_light), 0.0);
    vec3 light = albedo * (vec3(1.40, 1.20, 0.92) * facing + vec3(0.30, 0.36, 0.46));
    float haze = 1.0 - exp2(-0.012 * length(u_eye - v_world));
    light = mix(light, vec3(0.60, 0.62, 0.62), haze);
    o_color = vec4(sqrt(1.0 - exp2(-1.5 * light)), 1.0);
}
