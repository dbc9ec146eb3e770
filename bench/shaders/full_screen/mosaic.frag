#version 330
// A floor of stones in mortar under a low sun; the camera glides over it. Where the last frame
// showed a point of the floor follows from where the camera was then.
uniform vec2 u_resolution;
uniform float u_time;
uniform float u_time_delta;
out vec4 o_color;

const float ZOOM = 1.5, HEIGHT = 1.1, TILT = 0.55;

vec2 hash(vec2 p) {
    vec3 q = fract(vec3(p.xyx) * vec3(0.1031, 0.1030, 0.0973));
    q += dot(q, q.yzx + 33.33);
    return fract((q.xx + q.yz) * q.zy);
}

float noise(vec2 p) {
    vec2 cell = floor(p);
    vec2 f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    float low = mix(hash(cell).x, hash(cell + vec2(1.0, 0.0)).x, f.x);
    float high = mix(hash(cell + vec2(0.0, 1.0)).x, hash(cell + vec2(1.0, 1.0)).x, f.x);
    return mix(low, high, f.y);
}

// The stone of a point, and how far inside of it the point lies.
vec3 stone(vec2 p) {
    vec2 cell = floor(p);
    vec2 f = fract(p);
    vec2 best = vec2(0.0);
    float first = 8.0, second = 8.0;
    for (int j = -1; j <= 1; j++) {
        for (int i = -1; i <= 1; i++) {
            vec2 other = vec2(float(i), float(j));
            vec2 aside = other + 0.15 + 0.7 * hash(cell + other) - f;
            float d = dot(aside, aside);
            if (d < first) {
                second = first;
                first = d;
                best = cell + other;
            } else if (d < second) {
                second = d;
            }
        }
    }
    return vec3(best, sqrt(second) - sqrt(first));
}

// What the floor is made of.
vec3 material(vec2 p) {
    vec3 tile = stone(1.7 * p);
    vec2 own = hash(tile.xy + 3.0);
    float grain = 0.0, weight = 0.5;
    vec2 q = 2.3 * p + 9.0 * own;
    for (int octave = 0; octave < 6; octave++) {
        grain += weight * noise(q + 0.8 * noise(1.7 * q));
        q = mat2(1.2, 0.9, -0.9, 1.2) * q + 1.3;
        weight *= 0.6;
    }
    vec3 kind = mix(vec3(0.55, 0.32, 0.24), vec3(0.36, 0.43, 0.48), smoothstep(0.3, 0.7, own.x));
    kind = mix(kind, vec3(0.74, 0.69, 0.58), smoothstep(0.55, 0.9, own.y));
    return mix(vec3(0.30, 0.28, 0.26), kind * (0.65 + 0.35 * grain), smoothstep(0.02, 0.16, tile.z));
}

// The same, of nine places in the pixel: far away a stone is smaller than that.
vec3 smooth_material(vec2 p, vec2 right, vec2 up) {
    vec3 sum = vec3(0.0);
    for (int j = -1; j <= 1; j++) {
        for (int i = -1; i <= 1; i++) {
            sum += material(p + float(i) * right + float(j) * up);
        }
    }
    return sum / 9.0;
}

vec3 eye(float time) {
    return vec3(0.9 * sin(0.5 * time), HEIGHT, -0.8 * time);
}

vec3 ray() {
    vec2 at = (2.0 * gl_FragCoord.xy - u_resolution) / u_resolution.y;
    vec3 along = vec3(at, -ZOOM);
    return vec3(along.x, cos(TILT) * along.y + sin(TILT) * along.z, cos(TILT) * along.z - sin(TILT) * along.y);
}

// The point of the floor that the pixel shows. (The camera looks down so far that there is no sky.)
vec3 shown() {
    vec3 along = ray();
    return eye(u_time) - along * HEIGHT / min(along.y, -0.02);
}

vec4 clip(vec3 p, vec3 from) {
    vec3 seen = p - from;
    vec2 turned = vec2(cos(TILT) * seen.y - sin(TILT) * seen.z, sin(TILT) * seen.y + cos(TILT) * seen.z);
    return vec4(ZOOM * u_resolution.y / u_resolution.x * seen.x, ZOOM * turned.x, 0.0, -turned.y);
}

vec4 scPreviousClip() {
    return clip(shown(), eye(u_time - u_time_delta));
}

vec4 scCurrentClip() {
    return clip(shown(), eye(u_time));
}

void main() {
    vec3 p = shown();
    float away = distance(p, eye(u_time));
    vec2 right = vec2(0.6 * away / (ZOOM * u_resolution.y), 0.0);
    vec3 albedo = smooth_material(p.xz, right, right.yx * away / HEIGHT);
    vec3 view = normalize(eye(u_time) - p);
    vec3 sun = normalize(vec3(0.5 * sin(0.8 * u_time), 0.32, -0.8));
    float shine = pow(max(normalize(sun + view).y, 0.0), 60.0);
    vec3 color = albedo * (vec3(1.5, 1.3, 1.0) * sun.y + vec3(0.30, 0.34, 0.42)) + 0.5 * shine;
    color = mix(color, vec3(0.70, 0.66, 0.62), 1.0 - exp2(-0.02 * away * away));
    o_color = vec4(sqrt(1.0 - exp2(-2.0 * color)), 1.0);
}
