#version 330
// Weathered stone and copper under a sun, a sky and four lamps: what `./dev bench-emit` rewrites.
// Nothing in it is for the eye. It has the parts of a shader that somebody works with: noise,
// layers of material, bumps, several lights, soft shadows, fog and a tone curve.

struct Material {
    vec3 albedo;
    float roughness;
    float metalness;
    float occlusion;
    vec3 normal;
};

struct Lamp {
    vec3 position;
    vec3 color;
    float radius;
};

uniform vec3 u_eye;
uniform vec3 u_sun;
uniform vec3 u_sunColor;
uniform vec3 u_skyColor;
uniform vec3 u_groundColor;
uniform vec3 u_lampPositions[4];
uniform vec3 u_lampColors[4];
uniform float u_lampRadius;
uniform float u_wetness;
uniform float u_age;
uniform float u_exposure;
uniform float u_fogDensity;
uniform vec3 u_fogColor;
uniform sampler2D u_grain;

in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;

layout(location = 0) out vec4 f_color;

const float PI = 3.14159265;
const float EPSILON = 1e-4;
const vec3 STONE_LIGHT = vec3(0.72, 0.68, 0.61);
const vec3 STONE_DARK = vec3(0.31, 0.29, 0.27);
const vec3 COPPER = vec3(0.95, 0.64, 0.54);
const vec3 PATINA = vec3(0.25, 0.52, 0.43);
const vec3 MOSS = vec3(0.13, 0.19, 0.05);

// --- noise ---------------------------------------------------------------------------------------

float saturate(float x) {
    return clamp(x, 0.0, 1.0);
}

float square(float x) {
    return x * x;
}

vec3 hash33(vec3 p) {
    p = fract(p * vec3(0.1031, 0.1030, 0.0973));
    p += dot(p, p.yxz + 33.33);
    return fract((p.xxy + p.yxx) * p.zyx) * 2.0 - 1.0;
}

float hash13(vec3 p) {
    p = fract(p * 0.1031);
    p += dot(p, p.zyx + 31.32);
    return fract((p.x + p.y) * p.z);
}

vec3 fade(vec3 t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

float gradientNoise(vec3 p) {
    vec3 cell = floor(p);
    vec3 f = p - cell;
    vec3 u = fade(f);
    float a = dot(hash33(cell), f);
    float b = dot(hash33(cell + vec3(1.0, 0.0, 0.0)), f - vec3(1.0, 0.0, 0.0));
    float c = dot(hash33(cell + vec3(0.0, 1.0, 0.0)), f - vec3(0.0, 1.0, 0.0));
    float d = dot(hash33(cell + vec3(1.0, 1.0, 0.0)), f - vec3(1.0, 1.0, 0.0));
    float e = dot(hash33(cell + vec3(0.0, 0.0, 1.0)), f - vec3(0.0, 0.0, 1.0));
    float g = dot(hash33(cell + vec3(1.0, 0.0, 1.0)), f - vec3(1.0, 0.0, 1.0));
    float h = dot(hash33(cell + vec3(0.0, 1.0, 1.0)), f - vec3(0.0, 1.0, 1.0));
    float i = dot(hash33(cell + vec3(1.0, 1.0, 1.0)), f - vec3(1.0, 1.0, 1.0));
    float near = mix(mix(a, b, u.x), mix(c, d, u.x), u.y);
    float far = mix(mix(e, g, u.x), mix(h, i, u.x), u.y);
    return mix(near, far, u.z);
}

float valueNoise(vec3 p) {
    vec3 cell = floor(p);
    vec3 u = fade(p - cell);
    float a = mix(hash13(cell), hash13(cell + vec3(1.0, 0.0, 0.0)), u.x);
    float b = mix(hash13(cell + vec3(0.0, 1.0, 0.0)), hash13(cell + vec3(1.0, 1.0, 0.0)), u.x);
    float c = mix(hash13(cell + vec3(0.0, 0.0, 1.0)), hash13(cell + vec3(1.0, 0.0, 1.0)), u.x);
    float d = mix(hash13(cell + vec3(0.0, 1.0, 1.0)), hash13(cell + vec3(1.0, 1.0, 1.0)), u.x);
    return mix(mix(a, b, u.y), mix(c, d, u.y), u.z);
}

float fbm(vec3 p) {
    float sum = 0.5 * gradientNoise(p);
    p = p * 2.03 + 17.1;
    sum += 0.25 * gradientNoise(p);
    p = p * 2.01 + 9.7;
    sum += 0.125 * gradientNoise(p);
    p = p * 2.02 + 3.3;
    sum += 0.0625 * gradientNoise(p);
    return sum;
}

float ridged(vec3 p) {
    float sum = 0.0;
    float gain = 0.5;
    for (int octave = 0; octave < 4; octave++) {
        sum += gain * square(1.0 - abs(gradientNoise(p)));
        p = p * 2.1 + 5.3;
        gain *= 0.5;
    }
    return sum;
}

float turbulence(vec3 p) {
    float sum = abs(gradientNoise(p));
    sum += 0.5 * abs(gradientNoise(p * 2.0));
    sum += 0.25 * abs(gradientNoise(p * 4.0));
    return sum;
}

// --- layers --------------------------------------------------------------------------------------

vec3 veins(vec3 p) {
    float wave = sin(p.x * 4.0 + 5.0 * turbulence(p * 1.5));
    float vein = pow(saturate(0.5 + 0.5 * wave), 3.0);
    return mix(STONE_DARK, STONE_LIGHT, vein);
}

float speckles(vec3 p) {
    float coarse = valueNoise(p * 24.0);
    float fine = valueNoise(p * 71.0);
    return smoothstep(0.55, 0.9, coarse) * 0.6 + smoothstep(0.6, 0.95, fine) * 0.4;
}

float cracks(vec3 p) {
    float lines = ridged(p * 2.3 + 0.4 * fbm(p * 5.0));
    return smoothstep(0.62, 0.78, lines);
}

float growth(vec3 p, vec3 normal) {
    float up = saturate(normal.y * 0.6 + 0.4);
    float patches = fbm(p * 3.1) * 0.5 + 0.5;
    float shade = saturate(1.0 - dot(normal, u_sun));
    return smoothstep(0.45, 0.7, up * patches * (0.5 + 0.5 * shade) * u_age * 2.0);
}

vec3 bumped(vec3 p, vec3 normal, float strength) {
    const float STEP = 0.01;
    float here = fbm(p * 9.0);
    vec3 slope = vec3(
        fbm((p + vec3(STEP, 0.0, 0.0)) * 9.0) - here,
        fbm((p + vec3(0.0, STEP, 0.0)) * 9.0) - here,
        fbm((p + vec3(0.0, 0.0, STEP)) * 9.0) - here
    ) / STEP;
    vec3 tangential = slope - normal * dot(slope, normal);
    return normalize(normal - strength * tangential);
}

Material stone(vec3 p, vec3 normal) {
    Material made;
    vec3 grain = texture(u_grain, v_uv * 4.0).rgb;
    float spots = speckles(p);
    float gaps = cracks(p);
    made.albedo = veins(p) * mix(0.8, 1.1, grain.r);
    made.albedo = mix(made.albedo, STONE_DARK * 0.5, spots * 0.35);
    made.albedo *= 1.0 - 0.7 * gaps;
    made.roughness = mix(0.55, 0.9, saturate(spots + gaps));
    made.metalness = 0.0;
    made.occlusion = 1.0 - 0.5 * gaps;
    made.normal = bumped(p, normal, 0.04 + 0.08 * gaps);
    return made;
}

Material copper(vec3 p, vec3 normal) {
    Material made;
    float flow = fbm(p * vec3(6.0, 1.5, 6.0));
    float green = smoothstep(0.0, 0.35, flow + u_age * 0.5 - 0.2);
    float scratches = texture(u_grain, v_uv * vec2(1.0, 12.0)).g;
    made.albedo = mix(COPPER, PATINA, green) * mix(0.9, 1.0, scratches);
    made.roughness = mix(0.25 + 0.2 * scratches, 0.85, green);
    made.metalness = 1.0 - green;
    made.occlusion = 1.0 - 0.2 * green;
    made.normal = bumped(p * 0.7, normal, 0.015);
    return made;
}

Material blend(Material a, Material b, float amount) {
    Material made;
    made.albedo = mix(a.albedo, b.albedo, amount);
    made.roughness = mix(a.roughness, b.roughness, amount);
    made.metalness = mix(a.metalness, b.metalness, amount);
    made.occlusion = mix(a.occlusion, b.occlusion, amount);
    made.normal = normalize(mix(a.normal, b.normal, amount));
    return made;
}

void wet(inout Material material, float puddle) {
    material.albedo *= mix(1.0, 0.55, puddle);
    material.roughness = mix(material.roughness, 0.08, puddle);
    material.normal = normalize(mix(material.normal, vec3(0.0, 1.0, 0.0), 0.3 * puddle));
}

// --- light ---------------------------------------------------------------------------------------

float distribution(float nh, float roughness) {
    float a2 = square(square(roughness));
    return a2 / (PI * square(nh * nh * (a2 - 1.0) + 1.0) + EPSILON);
}

float visibility(float nl, float nv, float roughness) {
    float k = square(roughness + 1.0) / 8.0;
    float l = nl / (nl * (1.0 - k) + k);
    float v = nv / (nv * (1.0 - k) + k);
    return l * v / max(4.0 * nl * nv, EPSILON);
}

vec3 fresnel(float vh, vec3 f0) {
    return f0 + (1.0 - f0) * pow(1.0 - vh, 5.0);
}

vec3 reflected(Material material, vec3 view, vec3 light) {
    vec3 halfway = normalize(view + light);
    float nl = saturate(dot(material.normal, light));
    float nv = saturate(dot(material.normal, view)) + EPSILON;
    float nh = saturate(dot(material.normal, halfway));
    float vh = saturate(dot(view, halfway));
    vec3 f0 = mix(vec3(0.04), material.albedo, material.metalness);
    vec3 specular = fresnel(vh, f0) * distribution(nh, material.roughness);
    specular *= visibility(nl, nv, material.roughness);
    vec3 diffuse = material.albedo * (1.0 - material.metalness) / PI;
    return (diffuse + specular) * nl;
}

float softShadow(vec3 p, vec3 light) {
    float open = 1.0;
    for (int i = 1; i <= 5; i++) {
        float away = 0.06 * float(i);
        float height = 0.35 + 0.3 * fbm((p + light * away) * 1.7) - away;
        open = min(open, saturate(1.0 - 2.5 * height));
    }
    return 0.25 + 0.75 * open;
}

vec3 lampLight(Material material, vec3 p, vec3 view, Lamp lamp) {
    vec3 toLamp = lamp.position - p;
    float away = length(toLamp);
    if (away > lamp.radius) {
        return vec3(0.0);
    }
    float fall = square(saturate(1.0 - square(square(away / lamp.radius)))) / (away * away + 1.0);
    return reflected(material, view, toLamp / away) * lamp.color * fall;
}

vec3 ambient(Material material, vec3 view) {
    float up = material.normal.y * 0.5 + 0.5;
    vec3 sky = mix(u_groundColor, u_skyColor, up);
    vec3 mirrored = reflect(-view, material.normal);
    vec3 far = mix(u_groundColor, u_skyColor, smoothstep(-0.2, 0.4, mirrored.y));
    vec3 f0 = mix(vec3(0.04), material.albedo, material.metalness);
    vec3 shine = fresnel(saturate(dot(material.normal, view)), f0) * (1.0 - material.roughness);
    return (material.albedo * (1.0 - material.metalness) * sky + shine * far) * material.occlusion;
}

// --- the picture ---------------------------------------------------------------------------------

vec3 fogged(vec3 color, float away) {
    float amount = 1.0 - exp(-square(away * u_fogDensity));
    return mix(color, u_fogColor, amount);
}

vec3 toned(vec3 color) {
    color *= u_exposure;
    vec3 curve = color * (2.51 * color + 0.03) / (color * (2.43 * color + 0.59) + 0.14);
    return pow(clamp(curve, 0.0, 1.0), vec3(1.0 / 2.2));
}

void main() {
    vec3 p = v_position;
    vec3 normal = normalize(v_normal);
    vec3 view = normalize(u_eye - p);
    float border = smoothstep(-0.04, 0.04, fbm(p * 1.3) + 0.3 * p.y);
    Material material = blend(stone(p, normal), copper(p, normal), border);
    float moss = growth(p, material.normal);
    material.albedo = mix(material.albedo, MOSS, moss);
    material.roughness = mix(material.roughness, 0.95, moss);
    if (u_wetness > 0.0) {
        float pool = smoothstep(0.2, 0.6, valueNoise(p * 2.0) + normal.y - 0.5);
        wet(material, pool * u_wetness);
    }
    vec3 light = reflected(material, view, u_sun) * u_sunColor * softShadow(p, u_sun);
    light += lampLight(material, p, view, Lamp(u_lampPositions[0], u_lampColors[0], u_lampRadius));
    light += lampLight(material, p, view, Lamp(u_lampPositions[1], u_lampColors[1], u_lampRadius));
    light += lampLight(material, p, view, Lamp(u_lampPositions[2], u_lampColors[2], u_lampRadius));
    light += lampLight(material, p, view, Lamp(u_lampPositions[3], u_lampColors[3], u_lampRadius));
    light += ambient(material, view);
    float away = length(u_eye - p);
    f_color = vec4(toned(fogged(light, away)), 1.0);
}
