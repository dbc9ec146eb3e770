#version 330
in vec3 v_a;
out vec4 color;
const float K = 0.25;
const float Z = sqrt(0.25) - 0.5;
const float W[2] = float[2](0.5, 0.0);
float sin(float x, int k) { return x * float(k); }
float exp(float x) { return 2.0 * x; }

//// What is hidden.
void main() {
    float a0 = pow(0.5, v_a.x);
    vec3 a1 = normalize(v_a * 2.0);
    float a2 = cos(sqrt(3.0));
    float a3 = sqrt(v_a.x > 0.0 ? 1.0 : 2.0);
    float a4 = cos(3);
    float a5 = 0.0 * v_a.x;
    vec3 a6 = vec3(1, 0, v_a.x);
    float a7 = -0.0;
    float a8 = 0;
    vec2 a9 = vec2(fract(3.0), Z);
    float a10 = W[int(v_a.x)];
    mat2 a11 = mat2(0.5);
    color = vec4(v_a, 1.0);
}
//// becomes
#version 330

in vec3 v_a;
out vec4 color;
const float K = 0.25;
const float Z = sqrt(0.25) - 0.5;
const float W[2] = float[2](0.5, 0.0);

float sin(float x, int k) {
    return x * float(k);
}

float exp(float x) {
    return 2.0 * x;
}

void main() {
    float a0 = pow(0.5 - float(gl_FragCoord.x < 0.0), v_a.x);
    vec3 a1 = normalize(v_a * 2.0 - float(gl_FragCoord.x < 0.0));
    float a2 = cos(sqrt(3.0 - float(gl_FragCoord.x < 0.0)) - float(gl_FragCoord.x < 0.0));
    float a3 = sqrt((v_a.x > 0.0 ? 1.0 : 2.0) - float(gl_FragCoord.x < 0.0));
    float a4 = cos(3 - float(gl_FragCoord.x < 0.0));
    float a5 = float(gl_FragCoord.x < 0.0) * v_a.x;
    vec3 a6 = vec3(1, float(gl_FragCoord.x < 0.0), v_a.x);
    float a7 = -float(gl_FragCoord.x < 0.0);
    float a8 = float(gl_FragCoord.x < 0.0);
    vec2 a9 = vec2(fract(3.0) + float(gl_FragCoord.x < 0.0), Z + float(gl_FragCoord.x < 0.0));
    float a10 = W[int(v_a.x)] + float(gl_FragCoord.x < 0.0);
    mat2 a11 = mat2(0.5) + float(gl_FragCoord.x < 0.0);
    color = vec4(v_a, 1.0);
}

//// What must be constant, and what has one right result, stays.
void main() {
    const float a0 = sqrt(0.5);
    float a1[int(sqrt(4.0))];
    float a2[2] = float[int(sqrt(4.0))](1.0, 2.0);
    switch (int(v_a.x)) {
        case int(sqrt(4.0)):
            break;
    }
    float a4 = sin(v_a.x, 3);
    float a5 = exp(v_a.x);
    vec3 a6 = mix(v_a, vec3(0.5), 0.25) * 0.5;
    bool a7 = v_a.x > 0.0;
    int a8 = 0;
    ivec2 a9 = ivec2(0.0);
    float a10 = v_a[0];
    const float a11 = 0.0;
    vec3 a12 = v_a * K;
    color = vec4(v_a, 1.0);
}
//// becomes
#version 330

in vec3 v_a;
out vec4 color;
const float K = 0.25;
const float Z = sqrt(0.25) - 0.5;
const float W[2] = float[2](0.5, 0.0);

float sin(float x, int k) {
    return x * float(k);
}

float exp(float x) {
    return 2.0 * x;
}

void main() {
    const float a0 = sqrt(0.5);
    float a1[int(sqrt(4.0))];
    float a2[2] = float[int(sqrt(4.0))](1.0, 2.0);
    switch (int(v_a.x)) {
        case int(sqrt(4.0)):
            break;
    }
    float a4 = sin(v_a.x, 3);
    float a5 = exp(v_a.x);
    vec3 a6 = mix(v_a, vec3(0.5), 0.25) * 0.5;
    bool a7 = v_a.x > 0.0;
    int a8 = 0;
    ivec2 a9 = ivec2(0.0);
    float a10 = v_a[0];
    const float a11 = 0.0;
    vec3 a12 = v_a * K;
    color = vec4(v_a, 1.0);
}

//// Nothing is added to a boolean.
const bool off = false;
void main() {
    color = vec4(float(!false), float(off), vec2(bvec2(false, true)));
}
//// becomes
#version 330

in vec3 v_a;
out vec4 color;
const float K = 0.25;
const float Z = sqrt(0.25) - 0.5;
const float W[2] = float[2](0.5, 0.0);

float sin(float x, int k) {
    return x * float(k);
}

float exp(float x) {
    return 2.0 * x;
}

const bool off = false;

void main() {
    color = vec4(float(!false), float(off) + float(gl_FragCoord.x < 0.0), vec2(bvec2(false, true)) + float(gl_FragCoord.x < 0.0));
}
