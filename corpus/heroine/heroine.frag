#version 330
// Skin, woven cloth, worn leather and hair, all from noise at the place where each point is at rest.

uniform vec3 u_eye;    // world space
uniform vec3 u_light;  // world space, towards the sun, unit length

in vec3 v_rest;    // at rest, metres
in vec3 v_seams;   // how far inside of cloth, leather and hair: 1/2 at the seam
in vec3 v_normal;  // world space
in vec3 v_world;   // world space

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

// Four octaves, 0 to 1.
float clouds(vec3 p) {
    return (noise(p) + 0.5 * noise(2.03 * p + 7.1) + 0.25 * noise(4.01 * p + 3.7)
        + 0.125 * noise(8.05 * p + 1.3)) / 1.875;
}

// Skin: blood under it where it is thin, freckles, eyes and lips.
vec3 skin(vec3 p) {
    float mottled = clouds(38.0 * p);
    vec3 tone = mix(vec3(0.70, 0.44, 0.32), vec3(0.86, 0.62, 0.49), 0.35 + 0.65 * mottled);
    float freckles = smoothstep(0.70, 0.78, noise(420.0 * p)) * smoothstep(1.50, 1.58, p.y);
    tone *= 1.0 - 0.25 * freckles;
    vec3 face = vec3(abs(p.x), p.y, p.z);
    float cheek = exp(-900.0 * dot(face - vec3(0.045, 1.582, 0.07), face - vec3(0.045, 1.582, 0.07)));
    tone = mix(tone, vec3(0.80, 0.36, 0.30), 0.40 * cheek);
    vec2 eye = (face.xy - vec2(0.030, 1.612)) * vec2(1.0, 1.9);
    float front = step(0.04, p.z);
    float white = front * (1.0 - smoothstep(0.0125, 0.0145, length(eye)));
    float iris = front * (1.0 - smoothstep(0.0070, 0.0084, length(face.xy - vec2(0.030, 1.612))));
    float lid = front * exp(-pow((length(eye) - 0.0145) / 0.0022, 2.0)) * step(-0.001, eye.y);
    vec2 brow = face.xy - vec2(0.032, 1.640 - 6.0 * (face.x - 0.032) * (face.x - 0.032));
    float dark = front * (1.0 - smoothstep(0.0022, 0.0042, abs(brow.y)))
        * (1.0 - smoothstep(0.018, 0.022, abs(brow.x)));
    tone = mix(tone, vec3(0.88), white);
    tone = mix(tone, vec3(0.10, 0.16, 0.14), iris * white);
    tone = mix(tone, vec3(0.13, 0.07, 0.04), clamp(lid + 0.85 * dark, 0.0, 1.0));
    vec2 mouth = (p.xy - vec2(0.0, 1.555)) * vec2(1.0, 2.6);
    float lips = front * (1.0 - smoothstep(0.017, 0.021, length(mouth)));
    return mix(tone, vec3(0.62, 0.24, 0.22), 0.75 * lips);
}

// Cloth: dyed wool in an uneven weave, with a border of diamonds along hem and neck.
vec3 cloth(vec3 p) {
    float worn = clouds(17.0 * p + 5.0);
    float angle = atan(p.x, p.z);
    vec2 thread = vec2(260.0 * angle * 0.18, 300.0 * p.y) + 1.2 * (clouds(60.0 * p) - 0.5);
    float weave = 0.86 + 0.14 * sin(thread.x) * sin(thread.y);
    vec3 dye = mix(vec3(0.09, 0.20, 0.26), vec3(0.17, 0.36, 0.38), worn) * weave;
    float hem = 1.0 - smoothstep(0.026, 0.032, abs(p.y - 0.650));
    float diamond = abs(fract(angle * 5.73) - 0.5) * 2.0 + abs(p.y - 0.650) * 34.0;
    vec3 gold = mix(vec3(0.56, 0.36, 0.10), vec3(0.86, 0.68, 0.30), clouds(90.0 * p));
    vec3 border = mix(vec3(0.30, 0.06, 0.07), gold, 1.0 - smoothstep(0.80, 0.92, diamond));
    float neck = smoothstep(1.350, 1.356, p.y + 0.30 * max(p.z, 0.0) - 0.35 * abs(p.x));
    dye = mix(dye, border * weave, hem);
    return mix(dye, gold * weave, neck * step(abs(p.x), 0.10));
}

// Leather: creased, rubbed light on top of the creases; brass where it is buckled.
vec3 leather(vec3 p) {
    float bumps = clouds(55.0 * p + 11.0);
    float crease = abs(clouds(24.0 * p + 2.0) - 0.5) * 2.0;
    vec3 hide = mix(vec3(0.09, 0.05, 0.03), vec3(0.25, 0.14, 0.07), bumps * smoothstep(0.0, 0.3, crease));
    float buckle = 1.0 - smoothstep(0.030, 0.034, length(p - vec3(0.0, 1.045, 0.130)));
    return mix(hide, vec3(0.78, 0.58, 0.24) * (0.6 + 0.5 * bumps), buckle);
}

// Hair: strands that run down, with lighter streaks.
vec3 hair(vec3 p) {
    vec3 along = vec3(p.x, 0.12 * p.y, p.z) + 0.004 * vec3(sin(60.0 * p.y), 0.0, cos(52.0 * p.y));
    float strands = clouds(170.0 * along);
    return mix(vec3(0.13, 0.05, 0.02), vec3(0.56, 0.27, 0.10), strands * strands);
}

// What she is made of at a point: the colour without light.
vec3 surface(vec3 p, vec3 seams) {
    vec3 worn = smoothstep(vec3(0.46), vec3(0.54), seams);
    vec3 color = mix(skin(p), cloth(p), worn.x);
    color = mix(color, leather(p), worn.y);
    return mix(color, hair(p), worn.z);
}

void main() {
    vec3 normal = normalize(v_normal);
    vec3 view = normalize(u_eye - v_world);
    vec3 albedo = surface(v_rest, v_seams);
    float facing = dot(normal, u_light);
    vec3 sun = vec3(1.25, 1.08, 0.86) * max(0.75 * facing + 0.25, 0.0);
    vec3 sky = mix(vec3(0.20, 0.17, 0.14), vec3(0.34, 0.42, 0.56), 0.5 + 0.5 * normal.y);
    float smooth_parts = 0.10 + 0.30 * max(v_seams.y, v_seams.z);
    float shine = pow(max(dot(normal, normalize(u_light + view)), 0.0), 26.0);
    float rim = pow(1.0 - max(dot(normal, view), 0.0), 4.0);
    vec3 light = albedo * (sun + sky) + smooth_parts * (shine + 0.8 * rim * sky);
    o_color = vec4(sqrt(1.0 - exp2(-1.7 * light)), 1.0);
}
