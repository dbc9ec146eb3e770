#version 330
// Pillars of sandstone in a canyon, found by marching rays; the sun goes round them, the camera
// stands still. Where a ray ends does not depend on the sun.
uniform vec2 u_resolution;
uniform float u_time;
out vec4 o_color;

const float FAR = 24.0;
const vec3 EYE = vec3(0.0, 2.6, 7.0);
const vec3 HAZE = vec3(0.72, 0.66, 0.60);

struct Surface {
    vec3 place;
    vec3 normal;
    float open;  // share of the sky that is seen from there
};

float hash(vec2 p) {
    vec3 q = fract(vec3(p.xyx) * 0.1031);
    q += dot(q, q.yzx + 33.33);
    return fract((q.x + q.y) * q.z);
}

float noise(vec2 p) {
    vec2 cell = floor(p);
    vec2 f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    float low = mix(hash(cell), hash(cell + vec2(1.0, 0.0)), f.x);
    float high = mix(hash(cell + vec2(0.0, 1.0)), hash(cell + vec2(1.0, 1.0)), f.x);
    return mix(low, high, f.y);
}

// Distance to the ground and to a pillar in every cell, whose waist and lean differ.
float away(vec3 p) {
    float ground = p.y - 0.5 * noise(0.7 * p.xz) - 0.12 * noise(3.0 * p.xz);
    vec2 cell = floor(p.xz / 2.6);
    float own = hash(cell);
    vec2 aside = p.xz - 2.6 * (cell + 0.5) - 0.35 * vec2(own - 0.5, hash(cell + 7.0) - 0.5);
    float height = 0.8 + 2.2 * own;
    float waist = 0.28 + 0.16 * own + 0.06 * sin(9.0 * p.y + 6.0 * own) + 0.05 * sin(3.7 * p.y);
    float pillar = max(length(aside) - waist, p.y - height);
    return min(ground, 0.7 * pillar);
}

vec3 ray() {
    vec2 at = (2.0 * gl_FragCoord.xy - u_resolution) / u_resolution.y;
    return normalize(vec3(at.x, at.y - 0.28, -1.7));
}

// What the pixel shows. Beyond the horizon nothing is open.
Surface seen(vec3 along) {
    float way = 0.2;
    for (int i = 0; i < 72; i++) {
        float left = away(EYE + way * along);
        if (left < 5e-4 * way || way > FAR) {
            break;
        }
        way += 0.8 * left;
    }
    vec3 place = EYE + way * along;
    vec2 e = vec2(1e-3, -1e-3) * (1.0 + way);
    vec3 normal = normalize(
        e.xyy * away(place + e.xyy) + e.yyx * away(place + e.yyx)
        + e.yxy * away(place + e.yxy) + e.xxx * away(place + e.xxx)
    );
    float closed = 0.0;
    for (int i = 1; i < 6; i++) {
        float reach = 0.16 * float(i);
        closed += (reach - away(place + reach * normal)) / float(i * i);
    }
    return Surface(place, normal, way < FAR ? clamp(1.0 - 1.6 * closed, 0.0, 1.0) : 0.0);
}

void main() {
    vec3 along = ray();
    Surface stone = seen(along);
    float turn = 0.9 * u_time;
    vec3 sun = normalize(vec3(cos(turn), 0.55, sin(turn)));
    float strata = 0.5 + 0.5 * sin(11.0 * stone.place.y + 0.6 * sin(4.0 * stone.place.x));
    vec3 albedo = mix(vec3(0.52, 0.27, 0.16), vec3(0.80, 0.58, 0.38), strata);
    float lit = max(dot(stone.normal, sun), 0.0) * smoothstep(0.2, 0.8, stone.open);
    float shine = pow(max(dot(stone.normal, normalize(sun - along)), 0.0), 24.0);
    vec3 light = vec3(1.30, 1.12, 0.88) * lit + vec3(0.22, 0.26, 0.34) * stone.open;
    vec3 color = albedo * light + 0.12 * shine * lit;
    float far = length(stone.place - EYE) / FAR;
    vec3 sky = mix(HAZE, vec3(0.30, 0.44, 0.66), clamp(2.5 * along.y + 0.5, 0.0, 1.0));
    sky += vec3(1.0, 0.8, 0.5) * pow(max(dot(along, sun), 0.0), 32.0);
    color = mix(color, sky, smoothstep(0.3, 1.0, far));
    o_color = vec4(sqrt(1.0 - exp2(-2.0 * color)), 1.0);
}
