#version 330
// A painted wall by lantern light, 100 lines: what `./dev bench-emit` has `shadercache verify` check.

uniform vec3 u_eye;
uniform vec3 u_light;
uniform vec3 u_lantern;
uniform vec3 u_lanternColor;
uniform float u_time;
uniform float u_wear;

in vec3 v_position;
in vec3 v_normal;

layout(location = 0) out vec4 f_color;

const float PI = 3.14159265;
const vec3 PAINT = vec3(0.42, 0.11, 0.08);
const vec3 PLASTER = vec3(0.76, 0.71, 0.62);
const vec3 SKY = vec3(0.10, 0.14, 0.22);
const vec3 GROUND = vec3(0.09, 0.07, 0.05);

float hash(vec3 p) {
    p = fract(p * vec3(0.1031, 0.1030, 0.0973));
    p += dot(p, p.yzx + 33.33);
    return fract((p.x + p.y) * p.z);
}

float noise(vec3 p) {
    vec3 cell = floor(p);
    vec3 f = fract(p);
    vec3 u = f * f * (3.0 - 2.0 * f);
    float low = mix(
        mix(hash(cell), hash(cell + vec3(1.0, 0.0, 0.0)), u.x),
        mix(hash(cell + vec3(0.0, 1.0, 0.0)), hash(cell + vec3(1.0, 1.0, 0.0)), u.x),
        u.y
    );
    float high = mix(
        mix(hash(cell + vec3(0.0, 0.0, 1.0)), hash(cell + vec3(1.0, 0.0, 1.0)), u.x),
        mix(hash(cell + vec3(0.0, 1.0, 1.0)), hash(cell + vec3(1.0, 1.0, 1.0)), u.x),
        u.y
    );
    return mix(low, high, u.z);
}

float flaking(vec3 p) {
    float sum = 0.0;
    float weight = 0.5;
    for (int octave = 0; octave < 4; octave++) {
        sum += weight * noise(p);
        p = p * 2.03 + 11.7;
        weight *= 0.5;
    }
    return smoothstep(0.62 - 0.3 * u_wear, 0.68 - 0.3 * u_wear, sum);
}

float facets(float nh, float roughness) {
    float a = roughness * roughness;
    float d = nh * nh * (a * a - 1.0) + 1.0;
    return a * a / (PI * d * d);
}

float masking(float nl, float nv, float roughness) {
    float k = (roughness + 1.0) * (roughness + 1.0) / 8.0;
    return 1.0 / ((nl * (1.0 - k) + k) * (nv * (1.0 - k) + k));
}

vec3 lit(vec3 albedo, float roughness, vec3 normal, vec3 view, vec3 light) {
    vec3 halfway = normalize(view + light);
    float nl = max(dot(normal, light), 0.0);
    float nv = max(dot(normal, view), 0.0001);
    float nh = max(dot(normal, halfway), 0.0);
    float shine = 0.04 + 0.96 * pow(1.0 - max(dot(view, halfway), 0.0), 5.0);
    float gloss = 0.25 * shine * facets(nh, roughness) * masking(nl, nv, roughness);
    return (albedo / PI + gloss) * nl;
}

vec3 toned(vec3 color) {
    vec3 curve = color * (2.51 * color + 0.03) / (color * (2.43 * color + 0.59) + 0.14);
    return pow(clamp(curve, 0.0, 1.0), vec3(1.0 / 2.2));
}

void main() {
    vec3 normal = normalize(v_normal);
    vec3 view = normalize(u_eye - v_position);
    float bare = flaking(v_position * 3.0);
    float dust = noise(v_position * 17.0) * max(normal.y, 0.0);
    vec3 albedo = mix(PAINT, PLASTER, bare);
    albedo = mix(albedo, vec3(0.5), 0.6 * dust);
    float roughness = mix(0.35, 0.8, bare) + 0.2 * dust;
    vec3 toLantern = u_lantern - v_position;
    float away = length(toLantern);
    float flicker = 0.85 + 0.15 * noise(vec3(u_time * 5.0, 0.0, 0.0));
    vec3 color = lit(albedo, roughness, normal, view, u_light) * 0.6;
    if (away < 6.0) {
        vec3 glow = u_lanternColor * flicker / (1.0 + away * away);
        color += lit(albedo, roughness, normal, view, toLantern / away) * glow;
    }
    vec3 ambient = mix(GROUND, SKY, 0.5 + 0.5 * normal.y);
    f_color = vec4(toned(color * 3.0 + albedo * ambient), 1.0);
}
