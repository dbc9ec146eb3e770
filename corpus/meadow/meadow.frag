#version 330 core
// Petals with veins and blots, each poppy's own; light comes through them.

in vec3 v_position;
in vec3 v_world;
in vec3 v_normal;
in float v_part;
in float v_seed;

uniform vec3 u_eye;
uniform vec3 u_light;

out vec4 o_color;

float hash(vec3 p) {
    p = fract(p * vec3(0.1031, 0.1030, 0.0973));
    p += dot(p, p.yxz + 33.33);
    return fract((p.x + p.y) * p.z);
}

float noise(vec3 p) {
    vec3 cell = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    vec4 low = vec4(hash(cell), hash(cell + vec3(1, 0, 0)), hash(cell + vec3(0, 1, 0)), hash(cell + vec3(1, 1, 0)));
    cell.z += 1.0;
    vec4 high = vec4(hash(cell), hash(cell + vec3(1, 0, 0)), hash(cell + vec3(0, 1, 0)), hash(cell + vec3(1, 1, 0)));
    vec4 plane = mix(low, high, f.z);
    vec2 row = mix(plane.xz, plane.yw, f.x);
    return mix(row.x, row.y, f.y);
}

float cloud(vec3 p) {
    float sum = 0.0, weight = 0.5;
    for (int octave = 0; octave < 5; octave++) {
        sum += weight * noise(p);
        p = p * 2.03 + 7.1;
        weight *= 0.5;
    }
    return sum;
}

vec3 petal(vec3 p, float seed) {
    float around = atan(p.z, p.x - 0.02), out_ = length(p.xz - vec2(0.02, 0.0));
    float veins = cloud(vec3(around * 14.0, out_ * 5.0, seed * 9.0));
    float blots = cloud(vec3(p.xz * 22.0, seed * 5.0));
    vec3 red = mix(vec3(0.62, 0.03, 0.02), vec3(0.93, 0.20, 0.06), fract(seed * 1.7));
    red *= 0.75 + 0.5 * veins;
    float dark = smoothstep(0.12, 0.05, out_ + 0.06 * (blots - 0.5));
    return mix(red, vec3(0.05, 0.01, 0.03), dark);
}

vec3 surface(vec3 p, float part, float seed) {
    if (part > 1.5) {
        return vec3(0.10, 0.12, 0.03) * (0.5 + cloud(p * 90.0 + seed));
    }
    if (part > 0.5) {
        return petal(p, seed);
    }
    return mix(vec3(0.10, 0.22, 0.05), vec3(0.28, 0.40, 0.12), cloud(p * vec3(60.0, 14.0, 60.0) + seed));
}

void main() {
    vec3 albedo = surface(v_position, v_part, v_seed);
    vec3 n = normalize(v_normal), view = normalize(u_eye - v_world);
    if (dot(n, view) < 0.0) {
        n = -n;
    }
    float front = max(dot(n, u_light), 0.0), through = 0.45 * max(dot(-n, u_light), 0.0);
    float shade = 0.35 + 0.65 * smoothstep(0.0, 0.7, v_position.y);
    float gloss = pow(max(dot(reflect(-u_light, n), view), 0.0), 20.0);
    o_color = vec4(albedo * shade * (0.32 + 0.85 * (front + through)) + 0.06 * gloss, 1.0);
}
