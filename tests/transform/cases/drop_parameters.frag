#version 330
uniform float u_a;
in vec3 v_a;
out vec4 color;

//// An inout parameter that gives a written variable back stays.
//// functions: f h k
vec2 g;
void f(inout vec2 x) {
    g.y = 1.0;
}
void h(inout vec2 x, inout vec2 y) {
    y.x = 2.0;
}
void k(inout vec2 x, vec2 y) {
    g.x = y.x;
}
void main() {
    vec2 a;
    vec2 b;
    f(g);
    h(a, a);
    h(a, b);
    k(b, b);
    color = vec4(a, b);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
vec2 g;

void f(inout vec2 x) {
    g.y = 1.0;
}

void h(inout vec2 x, inout vec2 y) {
    y.x = 2.0;
}

void k(vec2 y) {
    g.x = y.x;
}

void main() {
    vec2 a;
    vec2 b;
    f(g);
    h(a, a);
    h(a, b);
    k(b);
    color = vec4(a, b);
}

//// What is not read goes, except for an argument with a side effect that cannot be moved.
//// functions: f g
float f(float x, float y) {
    return y;
}
float g(float x) {
    return 1.0;
}
void main() {
    float z = 1.0;
    color = vec4(f(u_a, z) + g(z++) + f(2.0, 3.0));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;

float f(float y) {
    return y;
}

float g(float x) {
    return 1.0;
}

void main() {
    float z = 1.0;
    color = vec4(f(z) + g(z++) + f(3.0));
}

//// Nothing that was not asked for.
//// functions: other
float f(float x, float y) {
    return y;
}
void main() {
    color = vec4(f(u_a, 1.0));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;

float f(float x, float y) {
    return y;
}

void main() {
    color = vec4(f(u_a, 1.0));
}

//// What is only handed down.
//// functions: f g
float g(float x, float y);
float early(float x) {
    return g(x, 2.0);
}
float f(float x) {
    return 1.0;
}
float g(float x, float y) {
    return f(x) + y;
}
void main() {
    color = vec4(g(u_a, 3.0) + early(u_a));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float g(float y);

float early(float x) {
    return g(2.0);
}

float f() {
    return 1.0;
}

float g(float y) {
    return f() + y;
}

void main() {
    color = vec4(g(3.0) + early(u_a));
}

//// What only passes through.
//// functions: f
void f(inout float x, out float y) {
}
void main() {
    float a = u_a;
    float b;
    f(a, b);
    color = vec4(a + b);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;

void f(out float y) {
}

void main() {
    float a = u_a;
    float b;
    f(b);
    color = vec4(a + b);
}

//// Arguments with side effects are moved, each once.
//// functions: f k
float g;
float h() {
    g += 1.0;
    return g;
}
float k(float x) {
    g *= 2.0;
    return g;
}
float f(float x) {
    return 1.0;
}
void main() {
    float a = f(k(h()));
    color = vec4(a + g);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float g;

float h() {
    g += 1.0;
    return g;
}

float k() {
    g *= 2.0;
    return g;
}

float f() {
    return 1.0;
}

void main() {
    h();
    k();
    float a = f();
    color = vec4(a + g);
}

//// An argument that discards is evaluated all the same: ahead of what does nothing, else in place.
//// functions: f g
float seen(float x) {
    if (x > 0.6) discard;
    return x;
}
float f(float x) {
    return u_a;
}
float g(float x) {
    return u_a;
}
void main() {
    float y = f(seen(v_a.x)) * v_a.y;
    float z = g(seen(v_a.y)) + dFdx(v_a.z);
    color = vec4(y, z, v_a.xy);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;

float seen(float x) {
    if (x > 0.6)
        discard;
    return x;
}

float f() {
    return u_a;
}

float g(float x) {
    return u_a;
}

void main() {
    seen(v_a.x);
    float y = f() * v_a.y;
    float z = g(seen(v_a.y)) + dFdx(v_a.z);
    color = vec4(y, z, v_a.xy);
}
