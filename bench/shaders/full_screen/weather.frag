#version 330
// Clouds, found by walking along rays through noise: they drift slowly, and the lightning in them is
// quick.
uniform vec2 u_resolution;
uniform float u_time;
out vec4 o_color;

float hash(vec2 p) {
    vec3 q = fract(vec3(p.xyx) * 0.1031);
    q += dot(q, q.yzx + 33.33);
    return fract((q.x + q.y) * q.z);
}

float noise(vec2 p) {
    vec2 cell = floor(p);
    vec2 f = fract(p);
    f = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    float low = mix(hash(cell), hash(cell + vec2(1.0, 0.0)), f.x);
    float high = mix(hash(cell + vec2(0.0, 1.0)), hash(cell + vec2(1.0, 1.0)), f.x);
    return mix(low, high, f.y);
}

float fbm(vec2 p) {
    float sum = 0.0, weight = 0.5;
    for (int octave = 0; octave < 5; octave++) {
        sum += weight * noise(p);
        p = mat2(1.6, 1.2, -1.2, 1.6) * p + 3.7;
        weight *= 0.5;
    }
    return sum;
}

// A ray through a layer of clouds: how much of them it meets, and how high up.
vec2 clouds(vec2 at, float time) {
    vec3 along = normalize(vec3(at - vec2(0.8, 0.3), 1.1));
    float met = 0.0, high = 0.0;
    for (int i = 0; i < 18; i++) {
        float height = 1.0 + 0.055 * float(i);
        vec2 p = 1.3 * along.xz * height / max(along.y + 0.55, 0.1) + vec2(0.05, 0.03) * time;
        vec2 bend = vec2(noise(1.7 * p + 0.04 * time), noise(1.7 * p + 5.2));
        float here = smoothstep(0.42, 0.9, fbm(p + 0.9 * bend + 0.09 * float(i)) + 0.1 * noise(4.0 * p));
        high += here * exp2(-3.0 * met) * (1.0 - 0.045 * float(i));
        met += 0.16 * here;
    }
    return vec2(1.0 - exp2(-4.0 * met), high);
}

void main() {
    vec2 at = gl_FragCoord.xy / u_resolution.y;
    vec2 cloud = clouds(at, u_time);
    // Three bolts, each with its own beat; clouds glow around them.
    float flash = 0.0;
    for (int bolt = 0; bolt < 3; bolt++) {
        float own = float(bolt);
        vec2 place = vec2(0.25 + 0.3 * own, 0.5 + 0.2 * sin(2.4 * own));
        float beat = pow(0.5 + 0.5 * sin((5.0 + 1.7 * own) * u_time + 2.0 * own), 6.0);
        flash += beat / (0.3 + 14.0 * dot(at - place, at - place));
    }
    vec3 sky = mix(vec3(0.05, 0.08, 0.17), vec3(0.16, 0.17, 0.25), at.y);
    vec3 color = mix(sky, vec3(0.42, 0.44, 0.50), cloud.x * (0.4 + 0.5 * cloud.y));
    color += vec3(0.55, 0.60, 0.95) * flash * (0.12 + 0.8 * cloud.x * cloud.y);
    o_color = vec4(sqrt(1.0 - exp2(-2.0 * color)), 1.0);
}
