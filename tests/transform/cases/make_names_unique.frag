#version 330
uniform float u_a;
in vec3 v_a;
out vec4 color;

//// Overloads and locals get names of their own.
float a;
float f(float x) {
    return x;
}
float f(vec2 x) {
    float a = x.x;
    {
        float a = a + 1.0;
        x.y = a;
    }
    return a + x.y;
}
float mix(float a) {
    return a;
}
void main() {
    a = u_a;
    color = vec4(f(a) + f(vec2(a)) + mix(a));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float a;

float f(float x) {
    return x;
}

float f_1(vec2 x) {
    float a_1 = x.x;
    {
        float a_2 = a_1 + 1.0;
        x.y = a_2;
    }
    return a_1 + x.y;
}

float mix_1(float a_3) {
    return a_3;
}

void main() {
    a = u_a;
    color = vec4(f(a) + f_1(vec2(a)) + mix_1(a));
}

//// Prototypes follow their functions.
float f(float x);
float f(vec2 x);
void main() {
    color = vec4(f(u_a) + f(vec2(u_a)));
}
float f(float x) {
    return x;
}
float f(vec2 y) {
    return y.x;
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float f(float x);
float f_1(vec2 x);

void main() {
    color = vec4(f(u_a) + f_1(vec2(u_a)));
}

float f(float x) {
    return x;
}

float f_1(vec2 y) {
    return y.x;
}

//// Nothing changes where nothing collides.
float f(float x) {
    float y = x;
    return y;
}
void main() {
    color = vec4(f(u_a));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;

float f(float x) {
    float y = x;
    return y;
}

void main() {
    color = vec4(f(u_a));
}

//// Names that proof mode makes keywords.
float sample(float precise) {
    return precise;
}
void main() {
    color = vec4(sample(u_a));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;

float sample_1(float precise_1) {
    return precise_1;
}

void main() {
    color = vec4(sample_1(u_a));
}
