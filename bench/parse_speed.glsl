// A piece of a shader of usual density; copies of it, NUMBER being 0, 1, 2, ..., make long files.
struct SurfaceNUMBER {
    vec3 position, normal;
    vec2 uv;
    float roughness;
};

const float WEIGHTS_NUMBER[3] = float[3](0.25, 0.5, 0.25);

float hashNUMBER(vec3 p) {
    p = fract(p * 0.3183099 + vec3(0.71, 0.113, 0.419)) * 17.0;
    return fract(p.x * p.y * p.z * (p.x + p.y + p.z));
}

float cloudNUMBER(in vec3 x) {
    vec3 cell = floor(x), w = fract(x);
    w = w * w * (3.0 - 2.0 * w);
    float near = mix(hashNUMBER(cell), hashNUMBER(cell + vec3(1.0, 0.0, 0.0)), w.x);
    float far = mix(hashNUMBER(cell + vec3(0.0, 1.0, 0.0)), hashNUMBER(cell + 1.0), w.x);
    return mix(near, far, w.y);  // Two of the three directions are enough here.
}

float fbmNUMBER(vec3 p, int octaves) {
    float sum = 0.0, scale = 0.5;
    for (int i = 0; i < octaves; i++) {
        sum += scale * cloudNUMBER(p);
        p = p * 2.02 + vec3(float(i), 0.1, -0.3);
        scale *= 0.5;
    }
    return sum;
}

vec3 lightNUMBER(SurfaceNUMBER s, vec3 eye, vec3 lamp, inout float shade) {
    vec3 to_eye = normalize(eye - s.position), to_lamp = normalize(lamp - s.position);
    vec3 halfway = normalize(to_eye + to_lamp);
    float lambert = max(dot(s.normal, to_lamp), 0.0);
    float gloss = pow(max(dot(s.normal, halfway), 0.0), mix(4.0, 128.0, 1.0 - s.roughness));
    if (lambert <= 0.0 || s.roughness > 0.95) {
        gloss = 0.0;
    } else if (s.roughness < 0.05) {
        gloss *= 2.0;
    }
    shade = shade * 0.5 + lambert;
    return vec3(lambert) + gloss * texture(u_image, s.uv * 4.0 + 0.5).rgb;
}

vec4 pieceNUMBER(vec3 position, vec2 uv, float time) {
    SurfaceNUMBER s = SurfaceNUMBER(position, normalize(position), uv, 0.4);
    float shade = 1.0;
    vec3 total = vec3(0.0);
    for (int k = 0; k < 3; ++k) {
        s.position.xz += vec2(cos(time), sin(time)) * WEIGHTS_NUMBER[k];
        total += lightNUMBER(s, u_eye, vec3(2.0, 3.0, float(k)), shade) * WEIGHTS_NUMBER[k];
    }
    total = mix(total, total.zyx, fbmNUMBER(position * 3.0, 5) > 0.5 ? 0.25 : 0.75);
    return vec4(total * shade, 1.0);
}
